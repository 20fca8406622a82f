# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""A copy of the sources whose headers hold all mutants, and the tests compiled from it, once."""

import json
import os
import re
import shutil
import subprocess

from page.mutations import switchable

LIBRARY = "include/Conformal_geometry_processing"
COPIED = [".cmake", ".install", "CMakeLists.txt", "README.md", "benchmark/support", "doc/licenses",
          "examples", "include", "test"]
FLAGS = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -w", "-DCGP_BUILD_DOC=OFF",
         "-DCGP_BUILD_BENCHMARKS=OFF", "-DCGP_BUILD_EXAMPLES=OFF", "-DCGP_HTML_REPORT=OFF"]
ERROR = re.compile(LIBRARY + r"/([\w./]+\.(?:h|cpp)):(\d+):")


def write_if_new(place, data):
    """Files that stay what they are keep their time, so that nothing is compiled again."""
    if not place.exists() or place.read_bytes() != data:
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(data)


class Mutated_copy:
    def __init__(self, root, folder, mutants, jobs):
        self.root, self.source, self.build = root, folder / "source", folder / "build"
        self.mutants, self.jobs = mutants, jobs
        self.ids = numbered(mutants)
        self.fixed_file = folder / "cannot_be_switched.json"
        self.fixed = set(json.loads(self.fixed_file.read_text())) if self.fixed_file.exists() else set()

    def texts(self):
        """The headers with a switch for each mutant that can have one."""
        headers = {}
        for mutant in self.mutants:
            headers.setdefault(mutant.header, {})
            if mutant.name not in self.fixed:
                headers[mutant.header][mutant] = self.ids[mutant]
        for header, ids in headers.items():
            yield header, switchable(ids, (self.root / LIBRARY / header).read_text(encoding="utf-8"))

    def write(self):
        files = {path.relative_to(self.root).as_posix(): path.read_bytes()
                 for name in COPIED for path in [self.root / name, *(self.root / name).rglob("*")]
                 if path.is_file()}
        files[f"{LIBRARY}/mutation.h"] = files["benchmark/support/mutation.h"]
        files.update((f"{LIBRARY}/{header}", text.encode()) for header, text in self.texts())
        for name, data in files.items():
            write_if_new(self.source / name, data)

    def compile(self, wanted):
        """Compiles the tests whose targets match; leaves out the switches that do not compile."""
        while True:
            self.write()
            result = self.ninja(wanted)
            bad = {(header, int(line)) for header, line in ERROR.findall(result.stdout)}
            bad = {m.name for m in self.mutants if (m.header, m.line) in bad} - self.fixed
            if result.returncode == 0 or not bad:
                break
            self.fixed |= bad
            self.fixed_file.write_text(json.dumps(sorted(self.fixed), indent=1))
        if result.returncode != 0:
            raise SystemExit(result.stdout[-4000:])
        return [self.build / "test" / target for target in self.targets(wanted)]

    def targets(self, wanted):
        if not (self.build / "build.ninja").exists():
            subprocess.run(["cmake", "-G", "Ninja", "-S", self.source, "-B", self.build, *FLAGS,
                            f"-DCMAKE_CXX_COMPILER={shutil.which('clang++') or 'g++'}"], check=True)
        listed = subprocess.run(["ninja", "-C", self.build, "-t", "targets", "all"], check=True,
                                capture_output=True, text=True).stdout
        return sorted(t for t in re.findall(r"^(test\.[\w.]+): phony", listed, re.MULTILINE)
                      if re.search(wanted, t))

    def ninja(self, wanted):
        return subprocess.run(["ninja", "-C", self.build, f"-j{self.jobs}", "-k0",
                               *self.targets(wanted)], check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def numbered(mutants):
    """A number for each, which depends on the mutants of its own header only."""
    headers = sorted({mutant.header for mutant in mutants})
    count, ids = {}, {}
    for mutant in mutants:
        count[mutant.header] = count.get(mutant.header, -1) + 1
        ids[mutant] = 100 * headers.index(mutant.header) + count[mutant.header]
    return ids
