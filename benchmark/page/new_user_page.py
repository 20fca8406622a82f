# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/new_user.md, from the record of benchmark/new_user."""

from page import plot
from page.tables import grouped, table


def blocks(rows):
    return {"steps": table(["way", "seconds (of the processor)"], [
        [way + ("" if some[0]["bare"] else ", packages installed"), "; ".join(step(row) for row in some)]
        for (way,), some in grouped(rows, "way").items()])}


def step(row):
    return f"{row['step']} {row['seconds']:.0f} ({row['cpu']:.0f})"


def kind(row):
    words = ("packages", "library", "module", "quickstart", "page", "compile")
    return next((word for word in words if word in row["step"]), "run and draw")


def figures(rows):
    seconds = {}
    for row in rows:
        way = seconds.setdefault(row["way"], {})
        way[kind(row)] = way.get(kind(row), 0) + round(row["cpu"])
    return {"new_user.svg": plot.bars(seconds, "Seconds of the processor to the first picture, by way")}
