# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The tables of doc/handles.md."""

from page.convergence_page import Series
from page.measurements import exponent
from page.tables import table

OPEN, CLOSED = 1, 1e-5  # limits of the period defect of the steps of a flow


def rows_of(rows, **names):
    return Series(row for row in rows if all(row[key] == value for key, value in names.items()))


def between(series, k, key):
    """The slope from the mesh before to this one."""
    return f"{exponent(series.values('h')[k - 1:k + 1], series.values(key)[k - 1:k + 1]):.2f}" \
        if k > 0 else ""


def edit_table(rows, surface, limit):
    series = rows_of(rows, table="edit", surface=surface, limit=limit)
    return table(["n", "faces", "Q mean - 1", "slope", "Q max - 1", "period defect", "closure",
                  "steps", "left out"],
                 [[str(row["n"]), f"{row['faces']:,}", f"{row['q_mean']:.4f}",
                   between(series, k, "q_mean"), f"{row['q_max']:.3f}", f"{row['gap']:.1e}",
                   f"{row['closure']:.1e}", str(row["steps"]), f"{100 * row['missing']:.0f} %"]
                  for k, row in enumerate(series)])


def drift(row):
    return row["after_re"] - row["before_re"]


def drift_table(rows):
    lines = []
    for row in rows_of(rows, table="drift", limit=OPEN):
        closed, = rows_of(rows, table="drift", limit=CLOSED, n=row["n"], tau=row["tau"])
        lines.append([str(row["n"]), f"1/{round(1 / row['tau'])}", f"{row['before_re']:.4f}",
                      f"{drift(row):+.4f}", f"{row['gap']:.1e}", f"{drift(closed):+.4f}",
                      f"{closed['gap']:.1e}", f"{closed['closure']:.1e}"])
    return table(["n", "tau", "Re at first", "drift, open", "gaps", "drift, closed", "gaps",
                  "closure"], lines)


def worst_slope(rows, surface):
    """Of Q mean between neighbouring meshes, with the default limit."""
    series = rows_of(rows, table="edit", surface=surface, limit=0)
    return min(exponent(series.values("h")[k:k + 2], series.values("q_mean")[k:k + 2])
               for k in range(len(series) - 1))
