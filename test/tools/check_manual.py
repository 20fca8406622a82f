#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""README, gallery and manual fit the sources: the README's program is the example first_program,
files in backticks and links exist, links lead to headings that exist, README and doc/ are short, every
measured page is what its data give, has a picture, and is in the index of evidence with numbers that it
has, every example and named parameter is in the manual, every page has a picture, every picture is shown on a
page and drawn by a program, and the version is the same everywhere. What is installed was built before.
"""

import re
import struct
import sys

import check_thesis_map
import sources

sys.dont_write_bytecode = True
sys.path.insert(0, str(sources.ROOT / "benchmark"))
from page import pages  # noqa: E402

DOC = sources.ROOT / "doc"
PAGES = ["README.md", "doc/overview.md", "doc/gallery.md", "doc/CHANGELOG.md", "doc/evidence.md"]
LONGEST_README = 400  # words
LARGEST_PICTURE = 2_000_000  # bytes
LONGEST_DOC = 45_000  # words of all pages in doc/, which must not grow again
LINK = re.compile(r"\]\((?!https?:)([^)#]*)(?:#([^)]+))?\)")
MEASURED = re.compile(r"(Written by|Measured\W+by|^)\s*`benchmark/\w+`", re.MULTILINE)
ROW = re.compile(r"^\| \[[^]]+\]\((\w+\.md)\) \| (.*) \|$", re.MULTILINE)
LISTS = {"CHANGELOG.md", "contents.txt", "developers.md", "errata.md", "parameters.md", "thesis_map.md", "types.txt",
         "versions.md"}
VERSIONED = ["doc/CHANGELOG.md", "doc/CITATION.cff", ".cmake/conanfile.py", ".cmake/package.nix",
             ".cmake/vcpkg/vcpkg.json"]
PICTURE = re.compile(r"\]\(figures/|\\cgalFigureBegin|\\image")
BLOCK = re.compile(r"(?s)```.*?```|\\code.*?\\endcode")
NUMBER = re.compile(r"(?<![\w.])-?\d[\d,]*(?:\.\d+)*(?:e-?\d+)?")


def the_program():
    example = (sources.ROOT / "examples/first_program.cpp").read_text(encoding="utf-8")
    program = example.split("//! [program]\n")[1]
    if f"```cpp\n{program}```" not in check_thesis_map.read("README.md"):
        yield "README.md: its program is not that of examples/first_program.cpp"


def headings(path):
    """The names that GitHub gives to the headings of a page."""
    lines = re.findall(r"^#+ +(.*)$", path.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", line.lower()).replace(" ", "-") for line in lines}


def links():
    folders = ("doc", "examples", "test", "benchmark", ".github")
    written = [sources.ROOT / "README.md", *DOC.glob("manual/*.txt"),
               *(path for folder in folders for path in (sources.ROOT / folder).rglob("*.md"))]
    for path in written:
        page = path.relative_to(sources.ROOT)
        base = sources.ROOT if path.suffix == ".txt" else path.parent
        for target, heading in LINK.findall(path.read_text(encoding="utf-8")):
            found = base / target if target else path
            if not found.exists():
                yield f"{page}: there is no {target}"
            elif heading and found.suffix == ".md" and heading not in headings(found):
                yield f"{page}: {target} has no heading {heading}"


def lengths():
    for name, paths, most in (("README.md", [sources.ROOT / "README.md"], LONGEST_README),
                              ("doc/", DOC.rglob("*.md"), LONGEST_DOC)):
        words = sum(len(path.read_text(encoding="utf-8").split()) for path in paths)
        if words > most:
            yield f"{name}: {words} words, more than {most}"


def evidence():
    results = dict(ROW.findall(check_thesis_map.read("doc/evidence.md")))
    for path in sorted(DOC.glob("*.md")):
        text = path.read_text(encoding="utf-8")
        if MEASURED.search(text) and path.name != "evidence.md":
            if path.name not in results:
                yield f"doc/evidence.md: without {path.name}"
            if "](figures/" not in text:
                yield f"doc/{path.name}: measurements without a picture"
    for page, result in results.items():
        text = (DOC / page).read_text(encoding="utf-8") if (DOC / page).exists() else ""
        for number in NUMBER.findall(result):
            if number not in text:
                yield f"doc/evidence.md: {page} has no {number}"


def examples():
    page = check_thesis_map.read("doc/manual/examples.txt")
    for path in sorted((sources.ROOT / "examples").glob("*.cpp")):
        if f"\\example {path.name}" not in page or f"\\ref {path.name}" not in page:
            yield f"doc/manual/examples.txt: without {path.name}"


def named_parameters():
    header = (sources.INCLUDE / sources.LIBRARY / "core/named_parameters.h").read_text(encoding="utf-8")
    page = check_thesis_map.read("doc/named_parameters.txt")
    for name in re.findall(r"\bX\(([a-z_]+)\)", header):
        if f"`{name}`" not in page:
            yield f"doc/named_parameters.txt: without {name}"


def pages_without_pictures():
    """Every page shows what it is about; lists to look things up in need not."""
    for path in sorted([*DOC.glob("*.md"), *DOC.glob("manual/*.txt")]):
        text = path.read_text(encoding="utf-8")
        if path.name not in LISTS and not PICTURE.search(text):
            yield f"doc/{path.relative_to(DOC)}: a page without a picture"


def pictures():
    pages = [*DOC.glob("*.md"), *DOC.glob("manual/*.txt"), sources.ROOT / "README.md"]
    shown = "".join(path.read_text(encoding="utf-8") for path in pages)
    programs = [*DOC.glob("draw_*"), *(sources.ROOT / "benchmark").rglob("*")]
    drawn = "".join(path.read_text(encoding="utf-8", errors="replace") for path in programs
                    if path.is_file())
    for picture in sorted((DOC / "figures").iterdir()):
        if picture.name not in shown:
            yield f"doc/figures/{picture.name} is shown on no page"
        beginnings = (picture.stem[:found.end()] + "{" for found in re.finditer("_", picture.stem))
        if picture.stem not in drawn and not any(beginning in drawn for beginning in beginnings):
            yield f"doc/figures/{picture.name} is drawn by no program"


def animation():
    """The picture of a stroke moves, is small enough for a first page, and runs for ever."""
    data = (DOC / "figures/stroke.png").read_bytes()
    control = data.find(b"acTL")
    frames, plays = struct.unpack(">II", data[control + 4:control + 12]) if control > 0 else (0, 1)
    if frames < 12 or plays != 0 or data.count(b"fcTL") != frames:
        yield f"doc/figures/stroke.png has {frames} frames, shown {plays or 'any number of'} times"
    if len(data) > LARGEST_PICTURE:
        yield f"doc/figures/stroke.png has {len(data)} bytes"


def installations():
    """What is installed in a block of commands was built in it before."""
    pages = [sources.ROOT / "README.md", *DOC.glob("*.md"), *DOC.glob("manual/*.txt")]
    for path in pages:
        for block in BLOCK.findall(path.read_text(encoding="utf-8")):
            before, found, _ = block.partition("cmake --install")
            if found and "cmake --build" not in before:
                yield f"{path.name}: cmake --install before anything was built"


def version():
    header = (sources.INCLUDE / sources.LIBRARY / "version.h").read_text(encoding="utf-8")
    version = ".".join(re.findall(r"VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))
    if f'VERSION "{version}"' not in header:
        yield "version.h: its text is not its numbers"
    for page in VERSIONED:
        first = re.search(r"(?m)^(?!cff-).*?(?:version\W+|## )(\d+\.\d+\.\d+)", check_thesis_map.read(page))
        if not first or first[1] != version:
            yield f"{page}: its version is not {version}"


def complaints():
    yield from the_program()
    for page in PAGES:
        yield from check_thesis_map.names_that_do_not_exist(page)
    yield from lengths()
    yield from links()
    yield from evidence()
    yield from pages.stale()
    yield from examples()
    yield from named_parameters()
    yield from pages_without_pictures()
    yield from pictures()
    yield from animation()
    yield from version()
    yield from installations()


if __name__ == "__main__":
    sources.finish(list(complaints()), "README and manual")
