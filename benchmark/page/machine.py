# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Builds the benchmarks, and says on what machine and with what they run."""

import os
import pathlib
import platform
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]

# One thread: those of a BLAS wait in busy loops, which would count as work. CHOLMOD asks for four
# whatever OMP_NUM_THREADS says; only the limit stops it.
ONE_THREAD = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1", OMP_THREAD_LIMIT="1")


def build(folder, *settings, target=None):
    """Builds the benchmarks, or one of them, in the folder."""
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
                    "-DCGP_BUILD_BENCHMARKS=ON", "-DCGP_BUILD_TESTS=OFF",
                    "-DCGP_BUILD_EXAMPLES=OFF", "-DCGP_BUILD_DOC=OFF", *settings], check=True)
    what = ["--target", target] if target else []
    subprocess.run(["cmake", "--build", folder, "--parallel", str(os.cpu_count()), *what],
                   check=True)


def first_line(*command):
    try:
        output = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout
        return output.splitlines()[0]
    except (OSError, subprocess.CalledProcessError, IndexError):
        return "unknown"


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.processor()


def setting(folder, name):
    """What CMake was told."""
    for line in (folder / "CMakeCache.txt").read_text(encoding="utf-8").splitlines():
        if line.startswith(f"{name}:"):
            return line.split("=", 1)[1]
    return ""


def compiler(folder):
    name = setting(folder, "CMAKE_CXX_COMPILER")
    return first_line(name, "--version") if name else "unknown"


def blas(program):
    """The file that the program loads as BLAS, links resolved."""
    libraries = subprocess.run(["ldd", program], stdout=subprocess.PIPE, text=True,
                               check=True).stdout
    for line in libraries.splitlines():
        words = line.split()
        if "blas" in words[0] and len(words) > 2:
            path = pathlib.Path(words[2]).resolve()
            return f"{path.parent.name}/{path.name}"
    return "none"


def describe(folder, program, flags="Release"):
    """Three lines of Markdown."""
    gigabytes = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return "\n".join([f"- processor: {processor()}, {os.cpu_count()} cores, {gigabytes:.0f} GiB",
                      f"- compiler: {compiler(folder)}, {flags}",
                      f"- BLAS: {blas(folder / 'benchmark' / program)}"])
