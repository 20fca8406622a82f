# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What the checks share: where the sources are, what they include, how a check reports."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIBRARY = "Conformal_geometry_processing"
SOLVERS = "Quaternionic_linear_algebra"  # the library below it
INCLUDE = ROOT / "include"
HOUSES = (INCLUDE / SOLVERS, INCLUDE / LIBRARY)  # where paths in texts may begin
PROGRAM = ROOT / "examples" / "conformal"
FOLDERS = ("include", "test", "examples", "benchmark", "doc")

# The only headers that may reach CGAL's GPL parts: one per mesh type, the method for CGAL's package
# of parameterizations, and CHOLMOD's.
GPL_HEADER = re.compile(r"(_Surface_mesh|_Polyhedron_3|_parameterizer_3)\.h$"
                        r"|/adapters/Cholmod_[^/]*\.h$")

# The headers over libraries that may be missing where the checks run, under licences of their own
# (SLEPc and PETSc: BSD).
OPTIONAL_HEADER = re.compile(r"/adapters/(Petsc|Slepc)_[^/]*\.h$")


def library(*suffixes):
    """The files of the libraries with one of the suffixes, as paths below include/."""
    return sorted(path.relative_to(INCLUDE) for path in INCLUDE.rglob("*") if path.suffix in suffixes)


def is_ours(name):
    """Whether an included name is one of the libraries'."""
    return name.startswith((f"{LIBRARY}/", f"{SOLVERS}/"))


def headers():
    return library(".h")


def files(*suffixes):
    """All our own files with one of the suffixes, as paths below the root."""
    found = (path for folder in FOLDERS for path in (ROOT / folder).rglob("*"))
    return sorted(path.relative_to(ROOT) for path in found
                  if path.is_file() and path.suffix in suffixes)


def program(root=PROGRAM):
    """The sources of the command-line program, as paths below its folder."""
    return sorted(path.relative_to(root) for path in root.rglob("*") if path.suffix in (".h", ".cpp"))


def program_modules(root=PROGRAM):
    """Which modules of the program each includes; a module is what is declared and defined in files of
    one name."""
    modules = {}
    for file in program(root):
        module = modules.setdefault(file.with_suffix(""), set())
        for _, name in includes(root / file):
            first, _, rest = name.partition("/")
            other = pathlib.PurePath(rest) if first == root.name else file.parent / name
            if (root / other).exists() and other.stem != file.stem:
                module.add(other.with_suffix(""))
    return modules


def includes(path):
    """(line number, included name) of every #include in the file."""
    pattern = re.compile(r'\s*#\s*include\s*[<"]([^>"]+)[>"]')
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = pattern.match(line)
        if match:
            yield number, match.group(1)


def finish(complaints, checked):
    """Prints the complaints, one a line, and exits as a test should."""
    for complaint in complaints:
        print(complaint)
    print(f"{len(complaints)} complaints about {checked}")
    sys.exit(1 if complaints else 0)
