# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/vector_units.md, from the record of benchmark/vector_units."""

from page import plot

UNITS = ["SSE2", "AVX2", "AVX-512"]
NATIVE = "-march=native"


def speed(row):
    """Of the widest unit that is chosen at run time, by that of the program for this machine."""
    return row[NATIVE] / row[[unit for unit in UNITS if unit in row][-1]]


def summary(rows):
    whole, factorizations = ([speed(row) for row in rows[1:] if row["what"].startswith(what)]
                             for what in ("whole", "factorization"))
    return (f"The factorization reaches at least {min(factorizations):.2f} times the speed of the native program, the "
            f"whole transformation {min(whole):.2f} to {max(whole):.2f} times.")


def blocks(rows):
    return {"machine": rows[0]["machine"], "summary": summary(rows)}


def figures(rows):
    return {"vector_units.svg": plot.dots(
        {f"{row['faces']:,} faces, {row['what']}": {name: row[name] for name in [*UNITS, NATIVE] if name in row}
         for row in rows[1:]}, "seconds", "Vector units")}
