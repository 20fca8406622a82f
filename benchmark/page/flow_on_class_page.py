# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/flow_on_class.md, from the record of benchmark/flow_on_class."""

import math

from page import plot
from page.tables import table

SPHERE = 4 * math.pi


def of_table(rows, name):
    return [row for row in rows if row["table"] == name]


def exact(rows):
    return {row["mesh"]: row for row in of_table(rows, "flow") if row["flow"] == "exact" and "energy" in row}


def flow_table(rows):
    """Of the flow on the class, a row a mesh; its energy beside those of the flow of the thesis and of cMCF."""
    plain = {row["mesh"]: row for row in of_table(rows, "flow") if row["flow"] == "plain"}
    cmcf = {row["mesh"]: row for row in of_table(rows, "cost") if "q_mean" in row}
    lines = []
    for mesh, row in exact(rows).items():
        other = cmcf.get(mesh)
        lines.append([mesh, str(row["genus"]), f"{row['energy_before']:.3f}", f"{row['energy']:.4f}",
                      f"{plain[mesh]['energy']:.3f}", f"{other['energy'] / SPHERE:.4f}" if other else "",
                      f"{row['q_mean']:.4f}", f"{other['q_mean']:.4f}" if other else "",
                      f"{row['cross_ratio']:.1e}", "yes" if not row["outcome"].startswith("exit") else "no"])
    return table(["mesh", "genus", "E before", "E", "plain", "cMCF", "Q mean", "cMCF", "cross-ratios", "verified"],
                 lines)


def blocks(rows):
    return {"flows": flow_table(rows)}


def costs(rows):
    names = {"step": "a step, mean", "worst_step": "the worst", "late_step": "a late one", "construction": "before all",
             "finish": "after all"}
    return {row["mesh"]: {name: row[key] for key, name in names.items() if key in row}
            for row in of_table(rows, "cost")}


def figures(rows):
    kept = {row["mesh"]: {} for row in of_table(rows, "flow")}
    for row in of_table(rows, "flow"):
        kept[row["mesh"]][{"exact": "on the class", "plain": "as in the thesis"}[row["flow"]]] = row["cross_ratio"]
    return {"flow_on_class_ratios.svg": plot.dots(
                kept, "largest change of log cross-ratios", "How well the class is kept"),
            "flow_on_class_costs.svg": plot.dots(costs(rows), "multiples of P", "What a step costs")}
