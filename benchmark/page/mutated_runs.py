# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs compiled tests with one mutant switched on, only those that come past it, the quickest first."""

import collections
import os
import re
import resource
import subprocess
import tempfile

MEMORY = 6 << 30  # bytes; a wrong size must not take the machine down
QUICK = 0.3  # seconds
FAILED = re.compile(r"\[  FAILED  \] ([\w./]+)")


def run(program, variables, options, seconds):
    """The outcome of a run, and the test that has failed."""
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", **variables)
    with tempfile.TemporaryDirectory() as folder:
        try:
            done = subprocess.run(
                [program, "--gtest_brief=1", *options], cwd=folder, env=environment, text=True,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=seconds, check=False,
                errors="replace",
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
        except subprocess.TimeoutExpired:
            return "does not end", ""
    failed = FAILED.search(done.stdout)
    outcome = {0: "survived", 1: "fails"}.get(done.returncode, "ends early")
    return outcome, failed[1] if failed else ""


class Mutated_runs:
    def __init__(self, programs, folder, budget):
        self.budget = budget  # seconds of tests for a mutant, as they take without one
        self.reaches = {}  # program -> {test: (seconds, numbers of mutants)}
        (folder / "reached").mkdir(exist_ok=True)
        for program in programs:
            self.reaches[program] = self.reached_by(program, folder / "reached" / program.name)

    def reached_by(self, program, record):
        if not record.exists() or record.stat().st_mtime < program.stat().st_mtime:
            record.write_text("")  # it stays empty where no mutated header is included
            outcome, test = run(program, {"CGP_MUTANTS_REACHED": str(record)}, [], None)
            if outcome != "survived":
                record.unlink()
                raise SystemExit(f"{program.name} {outcome} without a mutant: {test}")
        tests = {}
        # One line from the program, another one from the shared library.
        for name, time, *ids in map(str.split, record.read_text(encoding="utf-8").splitlines()):
            _, before = tests.get(name, (0, set()))
            tests[name] = (int(time) / 1000, before | {int(i) for i in ids})
        return tests

    def plans(self, number):
        """What to run for a mutant: (seconds, program, tests of a suite), first all that is quick."""
        for program, tests in self.reaches.items():
            times = {t: seconds for t, (seconds, ids) in tests.items() if number in ids}
            suites = collections.defaultdict(list)
            for test, seconds in times.items():
                suites[test.partition(".")[0], seconds > QUICK].append(test)
            for some in suites.values():
                yield sum(times[t] for t in some), program, some

    def judge(self, number):
        """The outcome for a mutant, and the test that kills it."""
        plans, rest = sorted(self.plans(number), key=lambda plan: plan[0]), self.budget
        for seconds, program, tests in plans:
            rest -= seconds
            if rest < 0:
                break
            outcome, test = run(program, {"CGP_MUTANT": str(number)},
                                ["--gtest_fail_fast", "--gtest_filter=" + ":".join(tests)],
                                20 + 10 * seconds)
            if outcome != "survived":
                return outcome, test or program.name
        return ("survived", "") if plans else ("survived", "no test comes past it")
