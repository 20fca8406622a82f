#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/developers.md fits the sources: its counted tables are up to date, within a tenth or five; the
files that it names exist, each function of a call sequence is in the file beside it, and recipes name
all files in which an existing example has to be named."""

import re

import check_thesis_map
import measure_structure
import sources

BASES = (sources.ROOT, *sources.HOUSES, sources.PROGRAM, sources.ROOT / "examples" / "python",
         sources.ROOT / "examples" / "python" / "src" / "conformal_geometry")
PLACEHOLDER = re.compile(r"NAME|\bX(_impl)?\.(?:h|cpp)")
NUMBER = re.compile(r"\d[\d,]*")
CALLS = re.compile(r"^\| depth \| function \| file \|.*\n\|[-:| ]*\n((?:\|.*\n)+)", re.MULTILINE)

# Of a recipe: where an existing example is named, by which words, and what is NAME in the names of files.
RECIPES = {
    "A boundary condition": (("include", "examples"),
                             r"\bKind::(free|positions|directions)|Boundary_condition::positions"
                             r"|\b(boundary|condition)\.targets|system(\(\))?\.(directions|positions)\(\)",
                             "positions"),
    "A linear solver": (("include", "examples", "doc", "benchmark"), "Eigen_hermitian_solver_traits", "Eigen"),
    "A rule of the verdict": (("include", "examples"),
                              r"Fault::collapsed|limits\.collapsed|\"(?:--)?collapsed_share", None),
    "A function for Python": (("examples/python",), r"\bsnap_to_conformal_class\b", None),
}


def is_near(old, new):
    """Whether two cells are the same but for numbers, which may be off by a tenth or by five."""
    if NUMBER.sub("0", old) != NUMBER.sub("0", new):
        return False
    values = ([int(word.replace(",", "")) for word in NUMBER.findall(cell)] for cell in (old, new))
    return all(abs(a - b) <= max(b / 10, 5) for a, b in zip(*values))


def counted_tables(page):
    counted = measure_structure.written(page)
    pairs = zip(measure_structure.TABLE.findall(page), measure_structure.TABLE.findall(counted))
    for (_, name, old), (_, _, new) in pairs:
        before, after = old.splitlines(), new.splitlines()
        if len(before) != len(after) or not all(map(is_near, before, after)):
            yield f"doc/developers.md: the table {name} is old: run test/tools/measure_structure.py"


def find(name):
    return next((base / name for base in BASES if (base / name).exists()), None)


def files(page):
    for name in sorted(set(re.findall(r"`([^`\s]+)`", page))):
        if (check_thesis_map.is_file_name(name) and not PLACEHOLDER.search(name)
                and not name.startswith("build/") and find(name) is None):
            yield f"doc/developers.md: there is no {name}"


def functions(page):
    for table in CALLS.findall(page):
        for _, calls, file, *_ in map(measure_structure.split_row, table.splitlines()):
            path = find(file.strip("`"))
            text = path.read_text(encoding="utf-8") if path else ""
            for name in re.findall(r"(~?\w+)\(\)", calls):
                if not re.search(rf"\b{name}\(", text):
                    yield f"doc/developers.md: {name}() is not in {file}"


def recipes(page):
    for title, (places, words, name) in RECIPES.items():
        section = page.partition(f"### {title}\n")[2].partition("\n##")[0]
        named = {find(word.replace("NAME", name or "NAME")) for word in re.findall(r"`([^`\s]+)`", section)}
        for path, text in (found for place in places for found in measure_structure.texts(place)):
            if re.search(words, text) and path not in named:
                yield f"doc/developers.md: \"{title}\" is without {path.relative_to(sources.ROOT)}"


def complaints():
    page = measure_structure.GUIDE.read_text(encoding="utf-8")
    yield from counted_tables(page)
    yield from files(page)
    yield from functions(page)
    yield from recipes(page)


if __name__ == "__main__":
    sources.finish(list(complaints()), "the guide for developers")
