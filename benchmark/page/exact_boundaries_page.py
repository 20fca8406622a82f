# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/exact_boundaries.md, from the record of benchmark/measure_exact_boundaries."""

import statistics

from page import plot
from page.measurements import exponent
from page.tables import count, extent, grouped, table

WRONG = 0.02  # of the diagonal


def resolutions(rows):
    return sorted({row["h"] for row in rows}, reverse=True)


def slope(rows):
    """Of the error of one domain in the edge length."""
    return exponent([row["h"] for row in rows], [row["error"] for row in rows])


def is_wrong(row):
    return row["verified"] and row["error"] > WRONG


def is_lost(rows):
    """Whether a finer mesh is refused than one that is solved."""
    verified = [row["verified"] for row in rows]
    return any(before and not after for before, after in zip(verified, verified[1:]))


def slope_table(rows):
    lines = []
    for names, some in grouped(rows, "domain", "boundary").items():
        cases = grouped(some, "case").values()
        finest = [row["error"] for row in some if row["h"] == min(resolutions(rows))]
        lines.append([*names, str(len(cases)), extent(map(slope, cases)), extent(finest, ".1e"),
                      f"{count(some, lambda row: row['verified'])} of {len(some)}",
                      str(count(some, is_wrong)), str(count(cases, is_lost))])
    return table(["domain", "boundary", "cases", "slope of the error", "error, finest", "verified", "of them wrong",
                  "refused, though solved coarser"], lines)


def blocks(rows):
    return {"slopes": slope_table(rows)}


def figures(rows):
    lines = {f"{domain}, {boundary}": [(h, statistics.median(row["error"] for row in some if row["h"] == h))
                                       for h in resolutions(rows)]
             for (domain, boundary), some in grouped(rows, "domain", "boundary").items()}
    ends = [h for h in resolutions(rows)]
    lines.update({f"slope {k}": plot.power(ends, y, k) for k, y in ((1, 6e-3), (2, 2e-2))})
    return {"exact_boundaries.svg": plot.curves(
        lines, "edge length, by the radius of the disk", "distance from the exact surface, by its diagonal",
        "Minimal surfaces of their boundaries", [name for name in lines if name.startswith("slope")])}
