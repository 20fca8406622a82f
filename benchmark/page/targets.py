# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What the solvers were built to reach, each target next to the value measured."""

from page import measurements
from page.measurements import bytes_per_vertex, poisson_ratio

ORIGINAL_2011 = {  # faces: (seconds, megabytes) of the implementation that came with the thesis
    8000: (0.30, 95), 33620: (1.64, 374), 131220: (8.2, 1519), 524880: (52, 6325)}

SMALL, MIDDLE, LARGE, HUGE = 150_000, 600_000, 1_000_000, 2_000_000  # faces


class Target:
    """`statement`, and `values(measurements)`: a list of (mesh, value). All of them must be at most,
    or at least, the bound."""

    def __init__(self, statement, values, at_most=None, at_least=None, form="{:.2f}"):
        self.statement, self.values, self.form = statement, values, form
        self.at_most, self.at_least = at_most, at_least

    def verdict(self, m):
        """(met, cells of the table): met is None where nothing has been measured."""
        found = self.values(m)
        wanted = f"≤ {self.at_most:g}" if self.at_most is not None else f"≥ {self.at_least:g}"
        if not found:
            return None, [self.statement, wanted, "not measured", "–"]
        ordered = sorted(found, key=lambda item: item[1], reverse=self.at_most is not None)
        mesh, worst = ordered[0]
        met = worst <= self.at_most if self.at_most is not None else worst >= self.at_least
        shown = self.form.format(worst) + (f" ({mesh})" if mesh else "")
        if len(ordered) > 1:
            shown += ", best " + self.form.format(ordered[-1][1])
        return met, [self.statement, wanted, shown, "met" if met else "**not met**"]


def anything(_):
    return True


def is_sphere(row):
    return measurements.is_sphere(row["mesh"])


def has_handles(row):
    """By Euler's formula, of a closed surface."""
    return row["vertices"] - row["faces"] // 2 < 2


def has_no_handles(row):
    return not has_handles(row)


def of_transform(model, value, most_faces, kind=anything):
    return lambda m: [(row["mesh"], value(row)) for row in m.measured("transform", model)
                      if row["faces"] <= most_faces and kind(row)]


def pairs(m, table, model, other, least_faces, most_faces):
    """(row of one model, row of the other) for every mesh that both were measured on."""
    for row in m.measured(table, model):
        match = m.row(table, other, row["mesh"])
        if match and least_faces <= row["faces"] <= most_faces:
            yield row, match


def times_slower(table, other, model, key, least_faces, most_faces):
    """How many times longer `other` takes than `model`."""
    return lambda m: [(a["mesh"], b[key] / a[key])
                      for a, b in pairs(m, table, model, other, least_faces, most_faces)]


def recipe_ratio(m):
    """Where three steps of the inverse power method give the surface: elsewhere the recipe is no
    answer to the same question."""
    return [(ours["mesh"], recipe["seconds"] / ours["seconds"])
            for ours, recipe in pairs(m, "transform", DOUBLE, "thesis recipe", 0, MIDDLE)
            if recipe["difference"] <= 1e-3]


def numeric_ratio(m):
    return [(row["mesh"], row["again"] / row["poisson_again"])
            for row in m.measured("factor", "native, quaternion n") if row["faces"] <= SMALL]


def original_ratio(index):
    def values(m):
        for row in m.measured("transform", "native, double"):
            if measurements.is_sphere(row["mesh"]) and row["faces"] in ORIGINAL_2011:
                ours = (row["seconds"], row["bytes"] / 1e6)
                yield row["mesh"], ORIGINAL_2011[row["faces"]][index] / ours[index]
    return lambda m: list(values(m))


def largest_gigabytes(m):
    return [(row["mesh"], row["bytes"] / 1e9) for row in m.measured("transform")
            if row["faces"] >= 8e6]


def later_step(model, value):
    return lambda m: [(row["mesh"], value(row)) for row in m.measured("flow", model)]


def of_strength(amplitudes, value, table="strength"):
    """Where an edit of such a strength comes out: what is refused is not an answer."""
    return lambda m: [(f"{row['mesh']}, {row['model']}", value(row))
                      for row in m.measured(table)
                      if row["amplitude"] in amplitudes and row["fault"] == "none"]


def mean(values):
    def mean_of(m):
        found = [value for _, value in values(m)]
        return [("", sum(found) / len(found))] if found else []
    return mean_of


def share_with_few_factorizations(m):
    rows = m.measured("strength")
    few = [row for row in rows if row["factorizations"] <= 3]
    return [("", 100 * len(few) / len(rows))] if rows else []


def speedup(model):
    return lambda m: [(row["mesh"], row["wall_1"] / row["wall_2"])
                      for row in m.measured("threads", model)]


DOUBLE, FLOAT, QUATERNION = "native, double", "native, float", "native, quaternion n"
TARGETS = [
    Target("first transformation of spheres, double: time / P, to 0.5M faces",
           of_transform(DOUBLE, poisson_ratio, MIDDLE, is_sphere), at_most=2.0),
    Target("first transformation of spheres, float factor: time / P, to 0.5M faces",
           of_transform(FLOAT, poisson_ratio, MIDDLE, is_sphere), at_most=1.5),
    Target("first transformation of any mesh, either: time / P, to 1M faces",
           lambda m: [pair for model in (DOUBLE, FLOAT)
                      for pair in of_transform(model, poisson_ratio, LARGE)(m)], at_most=3.0),
    Target("float factor: difference of positions / size",
           of_transform(FLOAT, lambda row: row["difference"], 10 * HUGE), at_most=1e-6,
           form="{:.1e}"),
    Target("quaternionic numeric factorization / CHOLMOD's *scalar* one, to 131k faces",
           numeric_ratio, at_most=1.4),
    Target("CHOLMOD, real 4n / quaternionic, numeric, to 131k faces",
           times_slower("factor", "CHOLMOD, real 4n", QUATERNION, "again", 0, SMALL), at_least=8),
    Target("the same at 0.5M faces",
           times_slower("factor", "CHOLMOD, real 4n", QUATERNION, "again", 450_000, MIDDLE),
           at_least=5),
    Target("CHOLMOD, complex 2n / quaternionic, numeric",
           times_slower("factor", "CHOLMOD, complex 2n", QUATERNION, "again", 0, MIDDLE),
           at_least=3),
    Target("Eigen SimplicialLDLT, real 4n / quaternionic, numeric, at 33k faces",
           times_slower("factor", "Eigen, real 4n", QUATERNION, "again", 33_000, 34_000),
           at_least=40),
    Target("thesis recipe / first transformation, to 0.5M faces, where it finds the surface (1e-3)",
           recipe_ratio, at_least=7),
    Target("implementation of 2011 / first transformation, time", original_ratio(0), at_least=15),
    Target("implementation of 2011 / first transformation, memory", original_ratio(1), at_least=5),
    Target("memory above the mesh, no handles, double: bytes per vertex",
           of_transform(DOUBLE, bytes_per_vertex, 2.2e6, has_no_handles), at_most=3100,
           form="{:.0f}"),
    Target("memory above the mesh, no handles, float factor: bytes per vertex",
           of_transform(FLOAT, bytes_per_vertex, 2.2e6, has_no_handles), at_most=1600,
           form="{:.0f}"),
    Target("memory above the mesh, handles, float factor: bytes per vertex",
           of_transform(FLOAT, bytes_per_vertex, 2.2e6, has_handles), at_most=4000, form="{:.0f}"),
    Target("scans, amplitude 0.5 and 1: mean of time / P",
           mean(of_strength((0.5, 1), poisson_ratio)), at_most=3.0),
    Target("scans, amplitude 0.5 and 1: time / P",
           of_strength((0.5, 1), poisson_ratio), at_most=4.5),
    Target("scans, amplitude 2: time / P", of_strength((2,), poisson_ratio), at_most=6),
    Target("scans, amplitude 4: time / P", of_strength((4,), poisson_ratio), at_most=10),
    Target("scans, lengths bounded by 2, amplitude 1.5: time / P",
           of_strength((1.5,), poisson_ratio, "bounded"), at_most=12),
    Target("scans, lengths bounded by 2, amplitude 3: time / P",
           of_strength((3,), poisson_ratio, "bounded"), at_most=25),
    Target("scans, all four amplitudes: percent with at most 3 factorizations",
           share_with_few_factorizations, at_least=95, form="{:.0f}"),
    Target("later step of a flow, double: time / P",
           later_step(DOUBLE, poisson_ratio), at_most=1.6),
    Target("later step of a flow, float factor: time / P",
           later_step(FLOAT, poisson_ratio), at_most=1.1),
    Target("first ten eigenvalues of D, and of D - rho: time / P",
           lambda m: [(f"{row['mesh']}, {row['model']}", poisson_ratio(row))
                      for row in m.measured("spectrum")], at_most=30),
    Target("8M faces: gigabytes", largest_gigabytes, at_most=10),
    Target("two threads, numeric factorization: speedup", speedup("numeric"), at_least=1.7),
    Target("two threads, first transformation: speedup", speedup("whole"), at_least=1.7),
    Target("assembly: percent of the first transformation",
           of_transform(DOUBLE, lambda row: 100 * row["assembly_share"], 10 * HUGE), at_most=2,
           form="{:.1f}"),
]
