# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/flow_real_meshes.md, from the record of benchmark/flow_real_meshes."""

from page import plot
from page.tables import count, extent, grouped, table

OURS = "conformal Willmore flow"


def flows(rows):
    return [row for row in rows if row["table"] == "flow"]


def flow_table(rows):
    return table(["time step", "runs", "energy falls", "verified", "Q mean of these", "Q max", "seconds"], [
        [f"{step:g}", str(len(some)), str(count(some, lambda row: row["falls"])), str(len(good)),
         extent((row["q_mean"] for row in good), ".4f"), extent((row["q_max"] for row in good), ".3g"),
         extent((row["seconds"] for row in some), ".1f")]
        for (step,), some in sorted(grouped(flows(rows), "time_step").items())
        for good in [[row for row in some if not row["outcome"].startswith("exit")]]])


def energies(rows):
    """mesh -> before, after"""
    found = {}
    for row in flows(rows):
        ends = found.setdefault(row["mesh"].removesuffix(".off"), {"before": row["energy_before"]})
        ends[f"time step {row['time_step']:g}"] = row["energy"]
    return found


def compared(rows, mesh):
    """Of each way and time step: what is reached, and the mean of Q then."""
    return {f"{'ours' if way == OURS else way}, {step:g}": [(row["roundness"], row["q_mean"]) for row in some]
            for (name, way, step), some in grouped([row for row in rows if row["table"] == "comparison"],
                                                   "mesh", "method", "time_step").items() if name == mesh}


def blocks(rows):
    return {"flows": flow_table(rows)}


def figures(rows):
    drawn = {mesh: plot.curves(compared(rows, f"{mesh}.off"), "roundness that is reached (0 is a sphere)",
                               "mean quasi-conformal error", f"{mesh} on its way to a sphere, by time step")
             for mesh in ("armadillo", "bunny00")}
    drawn["energy"] = plot.dots(energies(rows), "Willmore energy / 4 pi", "The flow of the thesis")
    return {f"flow_real_meshes_{name}.svg": svg for name, svg in drawn.items()}
