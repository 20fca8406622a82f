# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs the command-line program and reads its report, or a benchmark and what it prints."""

import json
import resource
import subprocess

from page import machine


def seconds_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(program, arguments, report, limit):
    """The exit code, the report if there is one, the last line of stderr, and the seconds of
    the processor."""
    report.unlink(missing_ok=True)
    start = seconds_of_children()
    try:
        process = subprocess.run([program, *arguments, "--json", report, "--quiet"], text=True,
                                 capture_output=True, timeout=limit)
        code, message = process.returncode, process.stderr.strip()
    except subprocess.TimeoutExpired:
        code, message = -1, f"stopped after {limit} seconds"
    seconds = seconds_of_children() - start
    content = json.loads(report.read_text(encoding="utf-8")) if report.exists() else {}
    return code, content, message.splitlines()[-1] if message else "", seconds


def printed(program, *arguments):
    """The rows that a benchmark prints as lines of JSON."""
    if not program.exists():
        raise SystemExit(f"{program} is not built")
    output = subprocess.run([program, *arguments], env=machine.ONE_THREAD, stdout=subprocess.PIPE,
                            text=True, check=True).stdout
    return [json.loads(line) for line in output.splitlines() if line.startswith("{")]
