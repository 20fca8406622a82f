# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/mutations.md, from the record of benchmark/mutate: which broken formulas the tests notice, and
why the others may live."""

import collections
import json
import pathlib

from page import plot
from page.tables import count, percent, table

COLORS = {"fails": "#009e73", "ends early": "#1b7837", "does not end": "#56b4e9", "survived": "#d55e00",
          "cannot be switched": "#7f7f7f"}
REASONS = pathlib.Path(__file__).with_name("mutation_reasons.json")  # written by hand
UNKNOWN = "Not looked into yet."


def is_killed(record):
    return record["outcome"] in ("fails", "ends early", "does not end")


def by_folder(rows):
    mutants = [row for row in rows if "header" in row]
    folders = sorted({row["header"].split("/")[0] for row in mutants})
    return {**{name: [row for row in mutants if row["header"].startswith(name + "/")] for name in folders},
            "all": mutants}


def score_table(rows):
    waiting = rows[0]["waiting"]
    waiting = {**waiting, "all": sum(waiting.values())}
    return table(["folder", "mutants", "killed", "score", "not judged yet"], [
        [name, str(len(some)), str(count(some, is_killed)), percent(some, is_killed, 1), str(waiting.get(name, 0))]
        for name, some in by_folder(rows).items()])


def reason_table(rows, most=6):
    reasons = json.loads(REASONS.read_text(encoding="utf-8"))
    counts = collections.Counter(reasons.get(f"{row['header']}: {row['after']}", UNKNOWN)
                                 for row in by_folder(rows)["all"] if not is_killed(row))
    shown = counts.most_common(most)
    shown.append(("others", counts.total() - sum(number for _, number in shown)))
    return table(["why survivors may live", "mutants"], [[reason, str(number)] for reason, number in shown])


def blocks(rows):
    return {"scores": score_table(rows), "reasons": reason_table(rows)}


def figures(rows):
    outcomes = {folder: {name: number for name in COLORS
                         if (number := count(some, lambda row, name=name: row["outcome"] == name))}
                for folder, some in by_folder(rows).items()}
    return {"mutations.svg": plot.bars(outcomes, "What the tests do with a broken formula", COLORS)}
