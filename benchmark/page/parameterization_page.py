# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/parameterization.md, from the record of benchmark/parameterize_meshes."""

from page import plot
from page.tables import extent, grouped, table

# Q of the spectral method and of its variant with normals of vertices, weighted by area, as an
# independent implementation has computed them.
REFERENCE = {"nefertiti": (1.04996, 1.08554), "mushroom": (1.03573, 1.18127),
             "patch-01": (1.06388, 2.55860), "lion-head": (1.06853, 4.45457),
             "mannequin-devil": (1.07195, 4.69208), "three_peaks": (1.65482, 2.80653),
             "mesh_with_border": (1.00210, 1.00273), "cylinder": (1.00000, 1.00130)}
SPECTRAL, VERTICES = "spectral", "spectral, normals of vertices"
ITERATED = "normals of vertices, as the reference"
DRAWN = [SPECTRAL, "LSCM", "LSCM, our solver", "ARAP, lambda 0", "ARAP, lambda 0, our solver", VERTICES]


def by_mesh(rows, name):
    """mesh -> method -> row"""
    return {mesh: {row["method"]: row for row in some}
            for (mesh,), some in grouped([row for row in rows if row.get("table") == name], "mesh").items()}


def method_table(rows):
    meshes = by_mesh(rows, "bounded").values()
    lines = []
    for method in next(iter(meshes)):
        found = [(mesh[method], mesh[SPECTRAL]["seconds"]) for mesh in meshes]
        if method != ITERATED and "our solver" not in method:  # which the plots show
            lines.append([method, extent((row["q_uniform"] for row, _ in found), ".3f"),
                          str(sum(row["flips"] for row, _ in found)),
                          extent(row["seconds"] / ours for row, ours in found)])
    return table(["method", "Q", "flips", "time by that of *spectral*"], lines)


def reference(rows):
    """How far the results are from those of the reference."""
    found = by_mesh(rows, "bounded")
    errors = [max(abs(found[mesh][method]["q_mean"] - expected[k]) for mesh, expected in REFERENCE.items())
              for k, method in enumerate((SPECTRAL, ITERATED))]
    return (f"The mean Q, weighted by area, differs from that of an independent implementation by at most "
            f"{errors[0]:.0e}; with normals of vertices and eight vectors, as there, by at most {errors[1]:.0e}.")


def blocks(rows):
    return {"machine": rows[0]["machine"], "methods": method_table(rows), "reference": reference(rows)}


def drawn(rows, name, value, methods=None):
    return {mesh: {method.replace("orbifold Tutte, ", ""): value(row) for method, row in found.items()
                   if methods is None or method in methods}
            for mesh, found in by_mesh(rows, name).items()}


def figures(rows):
    def error(row):
        return plot.error(row["q_uniform"])

    label = "mean quasi-conformal error of the faces, less 1"
    plots = {"angles": plot.dots(drawn(rows, "bounded", error, DRAWN), label, "Angles of maps to the plane"),
             "times": plot.dots(drawn(rows, "bounded", lambda row: row["seconds"], DRAWN), "seconds",
                               "Times of maps to the plane"),
             "closed": plot.dots(drawn(rows, "closed", error), label, "Orbifold Tutte embeddings, and spectral maps")}
    return {f"parameterization_{name}.svg": svg for name, svg in plots.items()}
