# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Counts the frames of the call stack each time that X is assembled, in `spin_transform()` of
examples/first_program.cpp and in `conformal spin`: builds both without optimization, and runs them
under gdb on a sphere."""

import re
import subprocess

import check_example
import sources

ASSEMBLY = f"{sources.LIBRARY}::assemble_dirac_energy"
FRAME = re.compile(r"^#\d+ .* at (\S+):\d+$", re.MULTILINE)
ANY_FRAME = re.compile(r"^#\d+ ", re.MULTILINE)
END = "end of a call stack"
# that of the libraries, which do not depend on the vector unit of the machine
ALIGNMENT = ["-DEIGEN_MAX_ALIGN_BYTES=16", "-DEIGEN_MALLOC_ALREADY_ALIGNED=0"]
GDB = f"""set pagination off
set width 0
set confirm off
set breakpoint pending on
break {ASSEMBLY}
commands
silent
backtrace -frame-arguments none
echo {END}\\n
continue
end
run
"""


def build(folder):
    """The folder of the two programs."""
    options = ["-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -g1", "-DCGP_BUILD_TESTS=OFF",
               "-DCGP_BUILD_BENCHMARKS=OFF", "-DCGP_BUILD_PYTHON=OFF", "-DCGP_BUILD_DOC=OFF",
               "-DCGP_STUDIO=OFF", "-DCGP_HTML_REPORT=OFF", "-DCGP_COMMANDS=spin"]
    subprocess.run(["cmake", "-S", sources.ROOT, "-B", folder, *options], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "conformal"], check=True)
    libraries = [f"-L{folder}", f"-Wl,-rpath,{folder}", "-lconformal_geometry_kernels",
                 "-lconformal_geometry_linear_algebra", "-lgmp", "-lmpfr"]
    flags = ["-std=c++17", "-O0", "-g1", *ALIGNMENT, f"-I{sources.INCLUDE}", "-isystem", "/usr/include/eigen3"]
    subprocess.run(["c++", *flags, sources.ROOT / "examples/first_program.cpp", *libraries,
                    "-o", folder / "examples/first_program"], check=True)
    return folder / "examples"


def stacks(folder, *command):
    """The call stack at each assembly, as the text of gdb."""
    (folder / "commands.gdb").write_text(GDB)
    run = subprocess.run(["gdb", "-nx", "-batch", "-x", "commands.gdb", "--args", *map(str, command)],
                         cwd=folder, check=True, capture_output=True, text=True)
    found = run.stdout.split(END)[:-1]
    if not found:
        raise RuntimeError(f"{command[0]} has not assembled X:\n{run.stdout}\n{run.stderr}")
    return found


def counts(stack):
    """The frames of the library, of the program, and all; the rest are those of std."""
    files = FRAME.findall(stack)
    library = sum("/include/" + sources.LIBRARY in file or "/include/" + sources.SOLVERS in file for file in files)
    program = sum("/examples/" in file for file in files)
    return library, program, len(ANY_FRAME.findall(stack))


def extent(numbers):
    low, high = min(numbers), max(numbers)
    return str(low) if low == high else f"{low} to {high}"


def rows(folder):
    """(program, frames of the library, of the program, all), each as words."""
    folder = folder.resolve()
    programs = build(folder)
    check_example.write_off(folder / "sphere.off", *check_example.sphere(3))
    spin = [programs / "conformal", "spin", "sphere.off", "--rho-expression", "1.5*sin(5*y)", "-o", "out.off"]
    calls = {
        "`spin_transform()` in `examples/first_program.cpp`":
            [programs / "first_program", "sphere.off", "out.off"],
        "`conformal spin`": spin,
        "`conformal spin --max-scale none`": [*spin, "--max-scale", "none", "--force"],
    }
    for name, command in calls.items():
        of_all = [counts(stack) for stack in stacks(folder, *command)]
        yield [name, *(extent(numbers) for numbers in zip(*of_all))]
