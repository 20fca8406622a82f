# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/compile_times.md, from the record of benchmark/measure_compile_times and benchmark/measure_builds."""

from page import plot
from page.tables import grouped, table


def by_program(rows):
    """program -> compiler -> row"""
    return {name: {row["compiler"]: row for row in some}
            for (name,), some in grouped([row for row in rows if "program" in row], "program").items()}


def program_table(rows):
    found = by_program(rows)
    first = next(iter(found.values()))
    return table(["program", *(f"{compiler}: s, ratio, MB" for compiler in first)], [
        [name, *(f"{row['seconds']:.1f}, {row['seconds'] / first[compiler]['seconds']:.1f}, {row['megabytes']:.0f}"
                 for compiler, row in some.items())] for name, some in found.items()])


def build_table(rows):
    return table(["what", "commit", "before", "now", "ratio"], [
        [row["build"], row["commit"], f"{row['before']:.1f}", f"{row['now']:.1f}", f"{row['now'] / row['before']:.2f}"]
        for row in rows if "build" in row])


def blocks(rows):
    return {"programs": program_table(rows), "builds": build_table(rows)}


def figures(rows):
    return {"compile_times.svg": plot.dots(
        {name.replace(", without this library", ""): {compiler: row["seconds"] for compiler, row in some.items()}
         for name, some in by_program(rows).items()}, "seconds", "What a program takes to compile")}
