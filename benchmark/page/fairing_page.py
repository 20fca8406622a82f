# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/fairing.md, from the record of benchmark/compare_fairing."""

import math

from page import plot
from page.tables import table

SPHERE = 4 * math.pi
FAITHFUL = 1.1  # Q mean below this
DRAWN = ["before", "explicit_mean_curvature_stable", "implicit_mean_curvature_stable",
         "modified_mean_curvature_stable", "discrete_Willmore,_16_fold_stable", "isometric_bending_stable",
         "ours_default"]
KEPT = {"throughout": "q_worst", "at the end": "q_mean"}  # when Q mean is below that


def meshes(rows):
    return list(dict.fromkeys(row["mesh"] for row in rows))


def of_role(rows, mesh, role):
    """The rows of a role, ours first."""
    return [row for row in rows if row["mesh"] == mesh and row["role"] in ("default", role)]


def number(value, form):
    """As short as it can be read."""
    if value is None:
        return "not finite"
    return format(value, form) if abs(value) < 1e4 else format(value, ".1e")


def is_moved(row):
    return row["steps"] > 0


def energy(row):
    return number(row["energy"] and row["energy"] / SPHERE, ".4f")


def before_table(rows):
    return table(["mesh", "faces", "E", "by angles", "least angle", "seconds"], [
        [row["mesh"], f"{row['faces']:,}", energy(row), f"{row['steiner_energy'] / SPHERE:.4f}",
         f"{row['least_angle']:.3f}", f"{of_role(rows, row['mesh'], 'default')[0]['budget']:.2f}"]
        for row in rows if row["method"] == "before"])


def plot_of(rows, mesh):
    """E - 1 has no logarithm where E is less than 1, so it is E that is drawn."""
    lines = {row["method"]: [tuple(map(float, moment.split(":"))) for moment in row["curve"].split()]
             for row in of_role(rows, mesh, "stable") if is_moved(row)}
    lines = {name.replace("mean curvature", "mean curv."):
             [(seconds, value / SPHERE) for seconds, value in points if seconds > 0]
             for name, points in lines.items()}
    return plot.curves(lines, "seconds of the processor", "Willmore energy / 4 pi",
                        f"{mesh}: largest stable time steps")


def keeps(key):
    return lambda row: is_moved(row) and row[key] is not None and row[key] < FAITHFUL


def best(rows, mesh, role, key):
    """The lowest of the others that keep Q mean, or none."""
    rivals = [row for row in of_role(rows, mesh, role) if "ours" not in row["method"] and keeps(key)(row)]
    return min(rivals, key=lambda row: row["energy"], default=None)


def verdict_cells(rows, mesh, when, key):
    ours, other = of_role(rows, mesh, "default")[0], best(rows, mesh, "stable", key)
    own = f"{energy(ours)}" + ("" if keeps(key)(ours) else f", but {ours[key]:.3f}")
    return [mesh, when, own, f"{energy(other)}, {other['method']}" if other else "none"]


def verdict_table(rows):
    return table(["mesh", "Q kept", "ours", "lowest of the others"], [
        verdict_cells(rows, mesh, when, key) for mesh in meshes(rows) for when, key in KEPT.items()])


def blocks(rows):
    return {"machine": f"- processor: {rows[0]['machine']}", "before": before_table(rows[1:]),
            "verdict": verdict_table(rows[1:])}


def figures(rows):
    return {f"fairing_{mesh}.svg": plot_of(rows[1:], mesh) for mesh in meshes(rows[1:])}
