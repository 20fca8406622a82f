# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/fuzzing.md, from its record, which has a row for each command or format of a campaign."""

from page import plot
from page.survey_outcome import COLORS
from page.tables import grouped, table

OUTCOMES = {"read": COLORS["verified"], "verified": COLORS["verified"], "not verified": COLORS["not verified"],
            "unsuitable": COLORS["unsuitable"], "refused": COLORS["unsuitable"], "cannot read": COLORS["cannot read"],
            "broken laws": "#d00000", "crash": "#d00000", "hang": "#d00000"}
TITLES = {"readers": "files for the readers", "commands": "surfaces for the program, by command"}


def campaigns(rows):
    return {campaign or TITLES[what]: some for (what, campaign), some in grouped(
        [{"campaign": None, **row} for row in rows], "what", "campaign").items()}


def total(rows):
    """outcome -> how many"""
    sums = {name: sum(row.get(name, 0) for row in rows) for name in OUTCOMES}
    return {name: number for name, number in sums.items() if number}


def blocks(rows):
    broken = ("broken laws", "crash", "hang")
    return {"campaigns": table(["campaign", "mutants", *broken], [
        [name, f"{sum(total(some).values()):,}", *(str(total(some).get(what, 0)) for what in broken)]
        for name, some in campaigns(rows).items()])}


def figures(rows):
    counts = {"readers": total([row for row in rows if row["what"] == "readers"]),
              **{row["command"]: total([row]) for row in rows if "command" in row},
              **{f"{name}, all formats": total(some) for name, some in campaigns(rows).items()
                 if name not in TITLES.values()}}
    return {"fuzzing.svg": plot.bars(counts, "What becomes of damaged files", OUTCOMES)}
