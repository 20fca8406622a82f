# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/components.md, from the record of benchmark/survey_components."""

import collections

from page import plot
from page.survey_outcome import COLORS
from page.tables import grouped, table


def command_table(rows):
    lines = []
    for (command,), some in grouped(rows, "command").items():
        tried = [row for row in some if "verified" in row]
        lines.append([f"`{command}`", str(sum(row["written"] for row in tried)), str(len(some) - len(tried)),
                      f"{sum(row['verified'] for row in tried)} of {sum(row['components'] for row in tried)}"])
    return table([f"of {len({row['mesh'] for row in rows})} meshes", "written", "refused as a whole",
                  "components verified"], lines)


def reason_table(rows):
    counts = collections.Counter()
    for row in rows:
        for reason, number in row.get("failed", {}).items():
            counts[row["command"], reason] += number
    return table(["command", "reason", "components"], [
        [f"`{command}`", reason.replace("|", "/"), str(number)] for (command, reason), number in counts.most_common()])


def summary(rows):
    names = ", ".join(f"by `{command}` {sum(row.get('written', False) for row in some)}"
                      for (command,), some in grouped(rows, "command").items())
    return f"Of {len({row['mesh'] for row in rows})} meshes are written: {names}."


def blocks(rows):
    return {"summary": summary(rows), "commands": command_table(rows), "reasons": reason_table(rows)}


def figures(rows):
    names = dict(zip(("verified", "not verified"), (COLORS["verified"], COLORS["not verified"])))
    counts = {command: {"verified": sum(row["verified"] for row in tried),
                        "not verified": sum(row["components"] - row["verified"] for row in tried)}
              for (command,), some in grouped(rows, "command").items()
              for tried in [[row for row in some if "verified" in row]]}
    return {"components.svg": plot.bars(counts, "Components, by command", names)}
