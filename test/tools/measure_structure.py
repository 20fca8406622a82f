#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes the counted columns of the tables in doc/developers.md.

usage: measure_structure.py [--measure FOLDER | --sizes PROGRAM]

A counted table stands between two comments of the page. A row that has a text of its own, as on
what a folder contains, keeps it. With --measure it also counts what has to be compiled, in FOLDER:
headers whose lines are executed (g++, gcov) and frames of the call stack (cmake, gdb). With --sizes
it prints how large the libraries and the interface are; PROGRAM is `conformal` with all commands.
"""

import pathlib
import re
import sys

import check_layers
import check_public_types
import check_reference
import check_subcommands
import count_frames
import count_headers
import sources

GUIDE = sources.ROOT / "doc" / "developers.md"
TABLE = re.compile(r"(<!-- (\w+): written by test/tools/measure_structure.py[^\n]*-->\n)(.*?)(?=<!-- end -->)",
                   re.DOTALL)
IN_BACKTICKS = re.compile(r"`([^`]+)`")

# What a successor follows when adding another one, and the words that name it in the sources.
EXAMPLES = {
    "operator `exterior_derivative`": r"exterior_derivative|boundary_operator",
    "boundary condition `positions`":
        r"Kind::positions|Boundary_condition::positions|[Pp]rescribed_positions|position_weight"
        r"|vertex_target_point_map",
    "solver `Eigen_hermitian_solver_traits`": r"Eigen_hermitian_solver_traits",
    "residual `Period_residual`": r"Period_residual",
    "named parameter `spectral_shift`": r"\bspectral_shift\b",
    "report field `missing_share`": r"missing_share",
    "verdict rule on `collapsed_share`":
        r"collapsed_share|Fault::collapsed|limits\.collapsed",
    "subcommand `split`":
        r"conformal split\b|\bsplit_command\b|\"split |commands/split\b|compare split|`split`",
    "Python function `snap_to_conformal_class`": r"\bsnap_to_conformal_class\b",
}
PLACES = ("include", "examples/conformal", "examples/python", "doc", "test", "benchmark")
RECORDS = {".jsonl", ".gz", ".json", ".png", ".svg", ".ipynb"}  # what was measured or drawn


def split_row(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def rows_of(table):
    """The rows of a table below its head."""
    return [split_row(line) for line in table.splitlines()[2:]]


def table_of(head, rows):
    """The table with a number aligned at the right where the head ends in a colon."""
    ruler = ["--:" if name.endswith(":") else "---" for name in head]
    lines = [f"| {' | '.join(map(str, row))} |\n" for row in ([name.rstrip(":") for name in head], *rows)]
    return "".join([lines[0], f"|{'|'.join(ruler)}|\n", *lines[1:]])


def counted(paths):
    """[number, lines] of some files."""
    texts = [path.read_text(encoding="utf-8") for path in paths]
    return [f"{len(texts):,}", f"{sum(text.count(chr(10)) for text in texts):,}"]


def layers(old, level_of, files_of):
    """The rows of a table of layers: (layer, folders, contents, files, lines). The page chooses which
    folders share a row, and what is said of them."""
    rows, left = [], dict(level_of)
    for _, folders, contents, *_ in rows_of(old)[:-1]:
        names = [name for name in IN_BACKTICKS.findall(folders) if name in left]
        if names:
            levels = {left.pop(name) for name in names}
            rows.append([", ".join(map(str, levels)), folders, contents,
                         *counted(path for name in names for path in files_of(name))])
    rows += [[level, f"`{name}`", "", *counted(files_of(name))] for name, level in left.items()]
    rows.sort(key=lambda row: -int(str(row[0]).partition(",")[0]))
    return [*rows, ["", "all", "", *counted(path for name in level_of for path in files_of(name))]]


def library(old):
    def files_of(folder):
        return [sources.INCLUDE / file for file in sources.library(".h", ".cpp")
                if check_layers.place(file)[0] == folder]

    levels = {**check_layers.LEVEL, sources.SOLVERS: 3, "algebra": 2, "threads": 1, "base": 0}
    return table_of(["layer", "folder", "contents", "files:", "lines:"], layers(old, levels, files_of))


def program(old):
    def files_of(folder):
        return [sources.PROGRAM / file for file in sources.program()
                if file.parent.as_posix() == folder]

    return table_of(["layer", "folder", "contents", "files:", "lines:"],
                    layers(old, check_layers.PROGRAM_LEVEL, files_of))


def subcommands(_):
    by_count = {}
    for name in check_subcommands.names():
        named = [file for file in sources.program()
                 if re.match(rf"{name}(_|$)", file.stem, re.IGNORECASE)]
        by_count.setdefault(len(named), []).append(f"`{name}`")
    return table_of(["files:", "subcommands"],
                    [[count, ", ".join(names)] for count, names in sorted(by_count.items())])


def texts(place):
    """(path, text) of the files in a folder that are written by hand, without this and the guide."""
    for path in sorted((sources.ROOT / place).rglob("*")):
        is_own = path in (GUIDE, pathlib.Path(__file__).resolve())
        if path.is_file() and path.suffix not in RECORDS and "__pycache__" not in path.parts and not is_own:
            yield path, path.read_text(encoding="utf-8", errors="replace")


def places(_):
    found = {name: [] for name in EXAMPLES}
    for place in PLACES:
        all_texts = [text for _, text in texts(place)]
        for name, words in EXAMPLES.items():
            found[name].append(sum(re.search(words, text) is not None for text in all_texts))
    head = ["example", *(f"`{place}/`:" for place in PLACES), "all:"]
    return table_of(head, [[name, *counts, sum(counts)] for name, counts in found.items()])


def frames(folder):
    return table_of(["program", "in `include/`:", "in `examples/`:", "all, with those of `std`:"],
                    count_frames.rows(folder / "frames"))


def executed(old, folder):
    folder = folder / "headers"
    folder.mkdir(parents=True, exist_ok=True)
    kept = {row[0]: row[-1] for row in rows_of(old)}
    return table_of(["folder", "modules:", "headers:", "contents"],
                    [[name, *counts, kept.get(name, "")] for name, *counts in count_headers.rows(folder)])


def sizes(program):
    files, lines = counted(sources.INCLUDE / file for file in sources.library(".h", ".cpp"))
    types, aliases = check_public_types.public_types()
    options = check_subcommands.options(program)
    tests = sum("TEST" in text for path, text in texts("test") if path.suffix == ".cpp")
    return table_of(["what", "number:"],
                    [["lines below `include/`", lines], ["files below `include/`", files],
                     ["public types", len(types) - len(aliases)],
                     ["named parameters", len(check_reference.names())],
                     ["options of `conformal spin`", options["spin"]],
                     ["options of all commands", options["all"]], ["files of tests", tests]])


COUNTED = {"library": library, "program": program, "subcommands": subcommands, "places": places}
MEASURED = {"frames": lambda _, folder: frames(folder), "executed": executed}


def written(page, folder=None):
    """The page with its tables counted, and those that need a folder where there is one."""
    def replaced(match):
        begin, name, old = match.groups()
        if name in COUNTED:
            return begin + COUNTED[name](old)
        return begin + (MEASURED[name](old, folder) if folder else old)

    return TABLE.sub(replaced, page)


def main():
    if len(sys.argv) not in (1, 3) or sys.argv[1:2] not in ([], ["--measure"], ["--sizes"]):
        sys.exit(__doc__.split("usage: ")[1].splitlines()[0])
    if sys.argv[1:2] == ["--sizes"]:
        print(sizes(sys.argv[2]), end="")
        return
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else None
    GUIDE.write_text(written(GUIDE.read_text(encoding="utf-8"), folder), encoding="utf-8")


if __name__ == "__main__":
    main()
