# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Signals at random times, limits of memory, and several programs with one output."""

import json
import random
import re
import shutil
import signal
import subprocess
import time

from page import machine
from page.fault_bench import OLD, PATIENCE, Check, is_whole, memory_limit, others

FAILING = machine.ROOT / "benchmark" / "support" / "failing_allocation.cpp"
TEMPORARY = re.compile(r"\.conformal-\d+-\d+\.tmp")
MEMORY_PATIENCE = 10  # seconds
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGKILL: None}


def spin_arguments(bench, folder):
    return bench.spin(folder / "output.ply") + ["--json", folder / "report.json"]


def flow_arguments(bench, folder):
    return ["flow", bench.mesh, "--steps", "4", "-o", folder / "output.ply", "--json",
            folder / "report.json"]


def duration(bench, arguments, folder):
    """The longer of two runs, in seconds."""
    times = []
    for _ in range(2):
        start = time.monotonic()
        bench.run(*arguments)
        times.append(time.monotonic() - start)
    shutil.rmtree(folder)
    return max(times)


def interrupt(bench, arguments, number, delay):
    """Exit code and seconds from the signal to the end."""
    with subprocess.Popen(bench.command(*arguments), stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as process:
        time.sleep(delay)
        process.send_signal(number)
        start = time.monotonic()
        try:
            return process.wait(PATIENCE), time.monotonic() - start
        except subprocess.TimeoutExpired:
            process.kill()
            return "hangs", PATIENCE


def look(check, bench, folder, what, number, code, had_old):
    """What may be in the folder after the signal."""
    output, report = folder / "output.ply", folder / "report.json"
    data = output.read_bytes() if output.exists() else None
    is_old = data == (OLD if had_old else None)
    may_be_new = code == 0 or number == signal.SIGKILL or what == "flow"
    new = data == bench.reference if what == "spin" else data and is_whole(data, bench.vertices)
    check.expect(is_old and code != 0 or may_be_new and new,
                 f"{what}, {number.name}, exit {code}: neither the old output nor a whole one")
    left = [name for name in others(folder, "output.ply", "report.json")
            if number != signal.SIGKILL or not TEMPORARY.fullmatch(name)]
    check.expect(not left, f"{what}, {number.name}, exit {code}: left {left}")
    try:
        if report.exists():
            json.loads(report.read_text(encoding="utf-8"))
    except ValueError:
        check.expect(False, f"{what}, {number.name}: a part of the report")


def signals(bench, number, tries, seed):
    """The signal at random times of spin and flow, half of them with an old output."""
    check, choice, slowest = Check(f"{number.name} at random times"), random.Random(seed), 0
    kinds = {"spin": spin_arguments, "flow": flow_arguments}
    lengths = {what: duration(bench, make(bench, bench.new_folder("timed")),
                              bench.folder / "timed") for what, make in kinds.items()}
    for attempt in range(tries):
        what = list(kinds)[attempt % 2]
        folder = bench.new_folder("interrupted")
        had_old = attempt % 4 < 2
        if had_old:
            (folder / "output.ply").write_bytes(OLD)
        delay = choice.uniform(0, 1.1 * lengths[what])
        code, seconds = interrupt(bench, kinds[what](bench, folder), number, delay)
        slowest = max(slowest, seconds)
        check.ended(f"exit {code}")
        check.expect(code in (0, CODES[number], -number), f"{what}: exit {code}")
        look(check, bench, folder, what, number, code, had_old)
        shutil.rmtree(folder)
    return check.row(f"slowest to end: {slowest:.1f} s")


def memory_sweep(bench, tries, name, environment):
    """Address spaces from 16 MiB to 1 GiB: done, or out of memory and no file. Less than what the
    libraries themselves need, the system's loader refuses (127), and the program never runs."""
    check = Check(f"`ulimit -v` from 16 MiB to 1 GiB, {name}")
    for attempt in range(tries):
        size = int(2 ** (24 + 6 * attempt / max(1, tries - 1)))
        folder = bench.new_folder("limited")
        code, message = bench.run(*bench.spin(folder / "output.ply"), patience=MEMORY_PATIENCE,
                                  preexec_fn=memory_limit(size), env=environment)
        loaded = not (code == 127 and "shared libraries" in message)
        check.ended(f"exit {code}" if loaded else "not loaded")
        mib = size >> 20
        check.expect(code in (0, 6) or not loaded, f"{mib} MiB: exit {code} {message}")
        check.expect(code in (0, "hangs") or not others(folder),
                     f"{mib} MiB: left {others(folder)}")
        if code == 0:
            check.expect((folder / "output.ply").read_bytes() == bench.reference,
                         f"{mib} MiB: another output")
        shutil.rmtree(folder)
    return check.row()


def preload(bench):
    """The library that has allocations fail, or None where there is no compiler."""
    library = bench.folder / "failing_allocation.so"
    compiler = shutil.which("c++")
    if compiler:
        subprocess.run([compiler, "-std=c++17", "-O1", "-fPIC", "-shared", FAILING, "-o", library,
                        "-ldl"], check=True)
    return library if compiler else None


def failing_allocations(bench, tries):
    """The k-th allocation from the begin of main() fails: out of memory, or an output. The first
    ones, in the command line, are tried more densely."""
    check, library = Check("one failing allocation"), preload(bench)
    if library is None:
        return check.row("left out: no compiler")
    environment = dict(machine.ONE_THREAD, LD_PRELOAD=str(library))
    counted = bench.folder / "allocations"
    bench.run(*bench.spin(bench.folder / "counted.ply"),
              env=dict(environment, COUNT_ALLOCATIONS=str(counted)))
    total = int(counted.read_text(encoding="ascii"))
    for number in sorted({1 + attempt**2 * total // tries**2 for attempt in range(tries)}):
        folder = bench.new_folder("failing")
        code, message = bench.run(*bench.spin(folder / "output.ply"), patience=MEMORY_PATIENCE,
                                  env=dict(environment, FAIL_ALLOCATION=str(number)))
        check.ended(f"exit {code}")
        check.expect(code in (0, 6), f"allocation {number}: exit {code} {message}")
        check.expect(code == 0 or not others(folder), f"allocation {number}: left {others(folder)}")
        shutil.rmtree(folder)
    return check.row(f"{total} allocations")


def concurrent_runs(bench, tries):
    """Four programs at once with the same output."""
    check = Check("four runs at once with one output")
    for _ in range(tries):
        folder = bench.new_folder("shared")
        command = bench.command(*bench.spin(folder / "output.ply"))
        processes = [subprocess.Popen(command) for _ in range(4)]
        codes = [process.wait(PATIENCE) for process in processes]
        check.ended(f"exits {sorted(codes)}")
        check.expect(codes == [0] * 4, f"exits {codes}")
        check.expect((folder / "output.ply").read_bytes() == bench.reference, "another output")
        check.expect(not others(folder, "output.ply"), f"left {others(folder)}")
        shutil.rmtree(folder)
    return check.row()
