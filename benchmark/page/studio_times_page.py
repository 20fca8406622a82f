# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/studio_times.md, from the record of benchmark/measure_studio."""

import statistics

from page import plot
from page.tables import table

FIRST, STROKE = 1, .15  # seconds wanted, at 20,000 faces


def both(times):
    return f"{statistics.median(times):.2f}, {max(times):.2f}"


def time_table(rows):
    return table(["shape", "faces", "opened", "first", "stroke", "exact", "pull", "exact", "step", "memory"], [
        [row["shape"], f"{row['faces']:,}", f"{row['opened']:.1f}", f"{row['first']:.2f}", both(row["strokes"]),
         f"{row['exact']:.1f}", both(row["pulls"]), f"{row['pulled']:.1f}", f"{row['step']:.1f}",
         f"{row['memory']:.0f} MB"] for row in rows])


def summary(rows):
    named = [row for row in rows if row["shape"] in ("torus", "dome")]
    first, stroke, longest = (max(value(row) for row in named) for value in (
        lambda row: row["first"], lambda row: statistics.median(row["strokes"]), lambda row: max(row["strokes"])))
    return (f"At about 20,000 faces the first answer takes at most {first:.2f} s ({FIRST} s were wanted), further ones "
            f"of a stroke {stroke:.2f} s in the median and {longest:.2f} s at the longest ({STROKE} s were wanted).")


def blocks(rows):
    return {"machine": rows[0]["machine"], "times": time_table(rows[1:]), "summary": summary(rows[1:])}


def answers(row):
    return {"opened": row["opened"], "first": row["first"], "stroke": statistics.median(row["strokes"]),
            "exact, after a stroke": row["exact"], "pull": statistics.median(row["pulls"]),
            "exact, after a pull": row["pulled"], "step of the flow": row["step"]}


def figures(rows):
    return {"studio_times.svg": plot.dots({f"{row['shape']}, {row['faces']:,} faces": answers(row) for row in rows[1:]},
                                          "seconds of the processor", "Answers of the studio")}
