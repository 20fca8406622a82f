# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/with_other_software.md, from the record of benchmark/measure_other_software."""

from page import plot
from page.tables import table

COLORS = {"kept": "#009e73", "lost": "#d55e00", "not in the format": "#bbbbbb", "not read": "#555555"}
KEPT = {"same": "kept", "exact": "kept", "kept": "kept", "-": "not in the format"}
WHAT = {"order": "order", "digits": "all digits", "colours": "colours", "texture": "texture coordinates",
        "rho": "rho", "quality": "quality"}


def blocks(rows):
    return {"table": table(list(rows[0]), [list(row.values()) for row in rows])}


def outcome(row, key):
    return KEPT.get(row[key], "lost") if row["order"] else "not read"


def figures(rows):
    counts = {}
    for key, name in WHAT.items():
        found = [outcome(row, key) for row in rows]
        counts[name] = {kind: found.count(kind) for kind in COLORS if kind in found}
    return {"with_other_software.svg": plot.bars(counts, "Programs and formats, by what survives in them", COLORS)}
