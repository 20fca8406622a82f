# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/deformers.md, from the record of benchmark/deformers."""

from page import plot
from page.tables import count, extent, grouped, table

RIGID = "as rigid as possible"


def is_better(row, rows, key):
    """Whether this is less than the deformer has it in the same motion."""
    theirs = next(other for other in rows if other["way"] == RIGID
                  and (other["motion"], other["degrees"]) == (row["motion"], row["degrees"]))
    return row[key] < theirs[key]


def way_table(rows):
    lines = []
    for (mesh,), all_ways in grouped(rows, "mesh").items():
        for (way,), some in grouped(all_ways, "way").items():
            if way == "half way":
                continue  # between its neighbours
            better = [str(count(some, lambda row, key=key: is_better(row, all_ways, key)))
                      for key in ("q_mean", "cross_ratio_rms")]
            lines.append([mesh, way, extent((row["q_mean"] for row in some), ".3f"),
                          "" if way == RIGID else f"{' and '.join(better)} of {len(some)}",
                          extent((row["scale_deviation"] for row in some), ".3f"),
                          extent((100 * row["missed"] for row in some), ".1f"),
                          extent((row["seconds"] for row in some), ".2f")])
    return table(["mesh", "way", "Q mean", "better", "lengths", "handles missed, %", "seconds"], lines)


def blocks(rows):
    return {"ways": way_table(rows)}


def figures(rows):
    errors = {f"{mesh}, {motion} {degrees:g}°": {row["way"]: plot.error(row["q_mean"]) for row in some}
              for (mesh, motion, degrees), some in grouped(rows, "mesh", "motion", "degrees").items()}
    return {"deformers.svg": plot.dots(errors, "mean quasi-conformal error, less 1",
                                       "Angles after a motion of the handles")}
