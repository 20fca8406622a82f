# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The lines that benchmark_solvers prints, and what is computed from them."""

import math


def exponent(sizes, values):
    """The slope p of the straight line that fits log(value) over log(size) best: value ~ size^p.
    None for fewer than two points."""
    points = [(math.log(s), math.log(v)) for s, v in zip(sizes, values)]
    if len({x for x, _ in points}) < 2:
        return None
    mean_x = sum(x for x, _ in points) / len(points)
    mean_y = sum(y for _, y in points) / len(points)
    return (sum((x - mean_x) * (y - mean_y) for x, y in points)
            / sum((x - mean_x) ** 2 for x, _ in points))


class Measurements:
    """Rows, which are dictionaries. A later row replaces an earlier one of the same name, so that
    single rows can be measured again."""

    def __init__(self, rows):
        self.by_name = {(row["table"], row["mesh"], row["model"]): row for row in rows if "table" in row}

    def rows(self, table, model=None, mesh=None):
        """Those that were measured, or left out, in the order of the run."""
        return [row for (t, m, o), row in self.by_name.items()
                if t == table and model in (None, o) and mesh in (None, m)]

    def measured(self, table, model=None, mesh=None):
        return [row for row in self.rows(table, model, mesh) if "left_out" not in row]

    def row(self, table, model, mesh):
        """The row, or None if it was not measured."""
        found = self.measured(table, model, mesh)
        return found[0] if found else None

    def meshes(self):
        """(name, faces, vertices): first the spheres, then the others, by their size."""
        found = {row["mesh"]: (row["mesh"], row["faces"], row["vertices"])
                 for row in self.by_name.values()}
        return sorted(found.values(), key=lambda mesh: (not is_sphere(mesh[0]), mesh[1]))

    def sphere_exponent(self, table, model, value, least_faces=0):
        """The exponent of value(row) in the number of vertices, on spheres."""
        rows = [row for row in self.measured(table, model)
                if is_sphere(row["mesh"]) and row["faces"] >= least_faces]
        return exponent([row["vertices"] for row in rows], [value(row) for row in rows])


def is_sphere(mesh):
    return mesh.isdigit()


def title(mesh):
    """Names a mesh for people."""
    if is_sphere(mesh):
        return f"sphere, {20 * int(mesh) ** 2:,} faces"
    name, _, splits = mesh.partition(":")
    return name.removesuffix(".off") + (f", split in {4 ** int(splits)}" if splits else "")


def poisson_ratio(row):
    return row["seconds"] / row["poisson"]


def bytes_per_vertex(row):
    return row["bytes"] / row["vertices"]
