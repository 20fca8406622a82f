# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs the command-line program in an empty folder within limits of time and memory, and tells
what became of it and what it left."""

import dataclasses
import json
import os
import resource
import signal
import pathlib
import subprocess
import tempfile
import threading

DOCUMENTED = {0: "done", 1: "failed", 2: "usage", 3: "cannot read", 4: "unsuitable",
              5: "cannot write", 6: "out of memory", 130: "interrupted", 143: "terminated"}
WALL_BY_PROCESSOR = 12  # a program that waits for longer than this is stopped, too
OUTPUT = "output.ply"


@dataclasses.dataclass
class Run:
    """code is negative for a signal, as of subprocess; files are those in the output's folder;
    memory is the largest resident set, in bytes."""
    code: int
    message: str
    seconds: float
    report: dict
    files: list
    output: bytes
    late: bool
    memory: int


def limits(processor, memory):
    """To be called in the child: no core files, seconds of the processor, bytes of memory."""
    def apply():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if processor:
            resource.setrlimit(resource.RLIMIT_CPU, (processor, processor + 5))
        if memory:
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    return apply


def wait(command, folder, processor, memory):
    """Exit code, stderr, whether the time was up, and what the process used."""
    with tempfile.TemporaryFile() as errors:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=errors,
                                   preexec_fn=limits(processor, memory))
        patience = threading.Timer(processor * WALL_BY_PROCESSOR, process.kill)
        patience.start()
        _, status, usage = os.wait4(process.pid, 0)
        patience.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        text = errors.read().decode("utf-8", "replace")
    late = process.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
    return process.returncode, text, late, usage


def last_error(text):
    """What the program says last, without its name."""
    lines = [line for line in text.strip().splitlines() if line] or [""]
    return lines[-1].removeprefix("conformal: error: ")


def run(program, arguments, processor, memory, output=True):
    """Runs it with --quiet and --json, and with -o if an output is wanted."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "folder"
        folder.mkdir()
        report = pathlib.Path(name) / "report.json"
        command = [program, *arguments, "--quiet", "--json", report]
        code, text, late, usage = wait(command + (["-o", OUTPUT] if output else []), folder,
                                       processor, memory)
        content = json.loads(report.read_text(encoding="utf-8")) if report.exists() else {}
        result = folder / OUTPUT
        return Run(code, last_error(text), usage.ru_utime + usage.ru_stime, content,
                   sorted(os.listdir(folder)), result.read_bytes() if result.exists() else b"",
                   late, usage.ru_maxrss << 10)
