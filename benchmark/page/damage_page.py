# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/damage.md, from the record of benchmark/damage."""

import collections

from page import plot
from page.survey_outcome import COLORS
from page.tables import table

WAYS = {"as it is": "as_it_is", "with --repair": "with_repair", "and --mollify": "with_mollify"}


def blocks(rows):
    return {"damages": table(["damage", "as it is", "repaired", "with --repair", "and --mollify"],
                             [list(row.values()) for row in rows])}


def figures(rows):
    colors = {"verified": COLORS["verified"], "verified, mollified": "#56b4e9", "refused": COLORS["unsuitable"]}
    counts = {}
    for way, key in WAYS.items():
        found = collections.Counter(row[key] if row[key] in colors else "refused" for row in rows)
        counts[way] = {name: found[name] for name in colors if found[name]}
    return {"damage.svg": plot.bars(counts, "Kinds of damage, by what becomes of the mesh", colors)}
