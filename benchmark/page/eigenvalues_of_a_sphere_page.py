# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/eigenvalues_of_a_sphere.md, from the record of doc/draw_dirac_spheres."""

from page import plot
from page.tables import table

KINDS = {"eigenvalue": "quotients", "pencil": "pencil"}


def errors(rows, key):
    """n -> the largest relative error of the eigenvalues that belong to it"""
    found = {}
    for row in rows:
        n = round(row["eigenvalue"])
        if n:
            found[n] = max(found.get(n, 0), abs(row[key] / n - 1))
    return dict(sorted(found.items()))


def blocks(rows):
    shown = (-11, -6, -2, 1, 5, 10)
    return {"errors": table(["n", *map(str, shown)], [
        [name, *(f"{errors(rows, key)[n]:.1e}" for n in shown)] for key, name in KINDS.items()])}


def figures(rows):
    values = sorted(row["eigenvalue"] for row in rows)
    lines = {f"{name}, n {sign} 0": [(abs(n), error) for n, error in errors(rows, key).items()
                                     if (n < 0) == (sign == "<")]
             for key, name in KINDS.items() for sign in "<>"}
    return {"eigenvalues_of_a_sphere.svg": plot.curves(
                {"each n comes |n + 1| times": list(enumerate(values))}, "number", "eigenvalue",
                "Eigenvalues of D of a sphere of 8 000 triangles", log=""),
            "eigenvalues_of_a_sphere_errors.svg": plot.curves(
                lines, "|n|", "largest relative error", "Errors of eigenvalues n")}
