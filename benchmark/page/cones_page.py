# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/cones.md, from the record of benchmark/measure_cones."""

import statistics

from page import plot
from page.tables import count, extent, grouped, table


def middle(rows, name, digits):
    return format(statistics.median(row[name] for row in rows), digits)


def method_table(rows):
    return table(["method", "cuts", "verified", "deviation", "Q", "flipped", "overlap", "charts"], [
        [method, str(cuts), f"{count(some, lambda row: row['verified'])}/{len(some)}",
         extent((row["deviation"] for row in good), ".2f"), middle(good, "q", ".3f"),
         str(sum(row["flipped"] for row in good)), middle(good, "overlap", ".2f"), middle(good, "charts", ".0f")]
        for (method, cuts), some in grouped(rows, "method", "cuts").items()
        for good in [[row for row in some if row["deviation"] is not None]] if cuts in (0, 16, 64)])


def blocks(rows):
    return {"methods": method_table([row for row in rows if row["closed"]]),
            "bounded": method_table([row for row in rows if not row["closed"]])}


def figures(rows):
    rows = [row for row in rows if row["closed"]]
    lines = {method: [(cuts, statistics.median(row["deviation"] for row in some if row["cuts"] == cuts
                                               and row["deviation"] is not None))
                      for cuts in sorted({row["cuts"] for row in some if row["deviation"] is not None})]
             for (method,), some in grouped(rows, "method").items()}
    return {"cones.svg": plot.curves(lines, "cones, or tips of cuts", "deviation of the log of the scale, median",
                                     "How areas change")}
