#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The package of CGAL that doc/package/lay_out makes stands alone: its headers include each other and
CGAL, two examples compile with this CGAL and succeed, its manual has no warnings.

usage: check_cgal_package.py COMPILER [FOLDER]   (keeps the package there; it must not exist)
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import check_example
import sources

LAY_OUT = sources.ROOT / "doc/package/lay_out"
EXAMPLES = {"first_program": check_example.sphere(4), "flatten_a_face": check_example.dome(12)}
# What CGAL's own set of aliases has beyond that of doc/Doxyfile.in, and takes from elsewhere.
VOCABULARY = {"cgalAutoToc": "", "cgalPkgDescriptionBegin{2}": "", "cgalPkgPicture{1}": "",
              "cgalPkgSummaryBegin": "", "cgalPkgAuthors{1}": "", "cgalPkgDesc{1}": r"\1",
              "cgalPkgManuals{2}": r"\ref \1, \ref \2", "cgalPkgSummaryEnd": "",
              "cgalPkgShortInfoBegin": "", "cgalPkgSince{1}": "", "cgalPkgDependsOn{1}": r"\1",
              "cgalPkgBib{1}": "", "cgalPkgLicense{1}": "", "cgalPkgShortInfoEnd": "",
              "cgalPkgDescriptionEnd": "", "cgalClassifedRefPages": "",
              "cgalCRPSection{1}": r"<b>\1</b>^^", "cgalCite{1}": r"[\1]"}


def names(package):
    """Includes that lead nowhere, and what still has a name from outside of CGAL."""
    folder = package / "include"
    for header in sorted(folder.rglob("*.h")):
        text = header.read_text(encoding="utf-8")
        houses = f"(?:{sources.LIBRARY}|{sources.SOLVERS})"
        for name in re.findall(rf"#include <(\S*{houses}/\S+)>", text):
            if not (folder / name).exists():
                yield f"{header.relative_to(package)}: there is no {name}"
        for name in re.findall(r"(?<!CGAL_)\b(?:CGP_|CONFORMAL_GEOMETRY_)\w+", text):
            yield f"{header.relative_to(package)}: the macro {name}"


def compile_and_run(package, compiler, work):
    """Two examples as a user of CGAL's repository would, but for the time that optimization takes."""
    run = {"check": True, "stdout": subprocess.DEVNULL}
    subprocess.run(["cmake", "-S", package / "examples" / sources.LIBRARY, "-B", work / "build",
                    f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_BUILD_TYPE=Release",
                    "-DCMAKE_CXX_FLAGS_RELEASE=-O0"], **run)
    subprocess.run(["cmake", "--build", work / "build", "--target", *EXAMPLES], **run)
    for name, mesh in EXAMPLES.items():
        check_example.write_off(work / "mesh.off", *mesh)
        subprocess.run([work / "build" / name, work / "mesh.off", work / f"{name}.ply"], **run)
        if not (work / f"{name}.ply").exists():
            yield f"{name} has written nothing"


def manual(package, work):
    """Warnings of doxygen, which reads the package's Doxyfile.in as CGAL's build does."""
    ours = (sources.ROOT / "doc/Doxyfile.in").read_text(encoding="utf-8")
    defaults = [line for line in ours.splitlines() if line.startswith("ALIASES") or re.match(
        r"(FILE_PATTERNS|EXTENSION_MAPPING|RECURSIVE|HIDE_UNDOC_CLASSES|EXTRACT_STATIC|QUIET|MACRO_EXP"
        r"|EXPAND_ONLY|USE_MATHJAX|WARN_IF|MARKDOWN|HAVE_DOT|GENERATE_LATEX)", line)]
    defaults += [f'ALIASES += "{name}={text}"' for name, text in VOCABULARY.items()]
    folder = package / "doc" / sources.LIBRARY
    defaults += ["PREDEFINED = DOXYGEN_RUNNING", "EXCLUDE_SYMBOLS = std boost Eigen",
                 f"EXAMPLE_PATH = {package / 'examples' / sources.LIBRARY}",
                 f"IMAGE_PATH = {folder / 'fig'}", f"OUTPUT_DIRECTORY = {work / 'manual'}"]
    (work / "defaults").write_text("\n".join(defaults) + "\n", encoding="utf-8")
    text = (folder / "Doxyfile.in").read_text(encoding="utf-8")
    for name, value in (("CGAL_DOC_PACKAGE_DEFAULTS", work / "defaults"), ("CGAL_DOC_VERSION", "x.y"),
                        ("CMAKE_SOURCE_DIR", package.parent)):
        text = text.replace(f"${{{name}}}", str(value))
    (work / "Doxyfile").write_text(text, encoding="utf-8")
    told = subprocess.run(["doxygen", work / "Doxyfile"], check=True, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True).stderr
    yield from (line for line in told.splitlines() if "licensesLGPL" not in line)  # CGAL's page
    if not list((work / "manual/html").glob("*spin__transform*")):
        yield "the manual has no page of spin_transform()"


def complaints(package, compiler, work):
    subprocess.run([LAY_OUT, package], check=True)
    yield from names(package)
    if shutil.which("doxygen"):
        yield from manual(package, work)
    yield from compile_and_run(package, compiler, work)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as scratch:
        place = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else scratch).resolve()
        sources.finish(list(complaints(place / sources.LIBRARY, sys.argv[1], pathlib.Path(scratch))),
                       "the package of CGAL")
