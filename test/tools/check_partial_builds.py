#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Builds of some commands are configured with every other option as it is, and cannot be installed;
names that are not commands are refused. A build of the studio compiles each file to WebAssembly once, if at all.

usage: check_partial_builds.py GENERATOR
"""

import pathlib
import subprocess
import sys
import tempfile

import sources


def configured(folder, commands):
    return subprocess.run(["cmake", "-S", sources.ROOT, "-B", folder, "-G", sys.argv[1],
                           f"-DCGP_COMMANDS={commands}"], check=False, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True)


def of_the_studio(folder):
    result = configured(folder, "studio")
    if result.returncode != 0:
        yield f"studio is not configured: {result.stderr}"
    units = [unit for part in ("program", "library") for unit in pathlib.Path(folder, "examples").glob(f"{part}_*.cpp")]
    files = [line for unit in units for line in unit.read_text(encoding="utf-8").splitlines()]
    if len(files) != len(set(files)):
        yield f"of {len(files)} files for WebAssembly {len(files) - len(set(files))} are compiled twice"
    targets = subprocess.run(["cmake", "--build", folder, "--target", "help"], check=False, stdout=subprocess.PIPE,
                             text=True)
    if units and "studio:" not in targets.stdout:
        yield "the page cannot be built"


def complaints(folder):
    result = configured(folder, "spin;info")
    if result.returncode != 0:
        yield f"spin;info is not configured: {result.stderr}"
    elif subprocess.run(["cmake", "--install", folder, "--prefix", folder], check=False,
                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0:
        yield "spin;info is installed"
    yield from of_the_studio(folder)
    for wrong in ("", "option_groups", "spin;nonsense"):
        result = configured(folder, wrong)
        if result.returncode == 0 or "there is no command" not in result.stderr:
            yield f"'{wrong}' is not refused: {result.stderr}"


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        sources.finish(list(complaints(place)), "builds of some commands")
