# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/handles.md, from the record of benchmark/measure_handles."""

from page import plot
from page.convergence_page import Series
from page.measurements import exponent
from page.tables import grouped, table

OPEN, CLOSED = 1, 1e-5  # limits of the period defect of the steps of a flow
SURFACES = {"grid": "regular torus", "irregular": "irregular torus"}
ERRORS = {"Q mean - 1": "q_mean", "closure": "closure", "period defect": "gap"}


def rows_of(rows, **names):
    return Series(row for row in rows if all(row[key] == value for key, value in names.items()))


def edits(rows, surface, limit=0):
    return rows_of(rows, table="edit", surface=surface, limit=limit)


def worst_slope(series):
    """Of Q mean between neighbouring meshes."""
    return min(exponent(series.values("h")[k:k + 2], series.values("q_mean")[k:k + 2])
               for k in range(len(series) - 1))


def edit_table(rows):
    return table(["mesh", "faces", "Q mean - 1", "Q max - 1", "period defect", "closure", "steps", "left out"], [
        [name, f"{row['faces']:,}", f"{row['q_mean']:.4f}", f"{row['q_max']:.3f}", f"{row['gap']:.1e}",
         f"{row['closure']:.1e}", str(row["steps"]), f"{100 * row['missing']:.0f} %"]
        for name, surface in SURFACES.items() for row in edits(rows, surface)])


def slopes(rows):
    """With the default limit, and whether another one matters."""
    found = {name: worst_slope(edits(rows, surface)) for name, surface in SURFACES.items()}
    same = all(edits(rows, surface).values("q_mean") == edits(rows, surface, .02).values("q_mean")
               for surface in SURFACES.values())
    return (f"Q mean - 1 falls with h: the smallest slope between neighbouring meshes is {found['grid']:.2f} on the "
            f"grid and {found['irregular']:.2f} on the irregular meshes. "
            + ("A limit of 2 % of the edges gives the same: it is not reached." if same else ""))


def drifts(rows):
    """name -> (n, change of the real part)"""
    return {f"{name}, tau = 1/{round(1 / tau)}": [(row["n"], row["after_re"] - row["before_re"]) for row in some]
            for name, limit in (("open", OPEN), ("closed", CLOSED))
            for (tau,), some in grouped(rows_of(rows, table="drift", limit=limit), "tau").items()}


def blocks(rows):
    return {"slopes": slopes(rows), "edits": edit_table(rows)}


def figures(rows):
    errors = {f"{what}, {name}": edits(rows, surface).points(key, "h")
              for what, key in ERRORS.items() for name, surface in SURFACES.items()}
    return {"handles_edits.svg": plot.curves(errors, "mean edge length", "error", "An edit of a torus"),
            "handles_drift.svg": plot.curves(drifts(rows), "n, of meshes of 2n x n points", "change of the real part",
                                             "The conformal class of a twisted torus", log="x")}
