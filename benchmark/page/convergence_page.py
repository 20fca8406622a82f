# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/convergence.md, from the record of benchmark/measure_convergence."""

from page import plot
from page.measurements import exponent
from page.tables import extent, table

CLOSED = ["sphere", "ellipsoid", "torus"]
NAMES = {"q_mean": "Q mean", "q_p99": "Q 99 %", "q_max": "Q max", "ratio_rms": "cross-ratio rms",
         "ratio_max": "cross-ratio max", "shape": "shape", "curvature": "curvature"}
ADJOINT, THESIS, NONE = "adjoint", "thesis", "none"
ANNULI = ["annulus, binormals", "annulus, tangents", "annulus, free"]


class Series(list):
    """The rows of one case, from the coarsest mesh or the largest time step to the finest."""

    def values(self, key):
        return [row[key] for row in self]

    def slope(self, key, by):
        return exponent(self.values(by), self.values(key))

    def last_slope(self, key, by):
        return exponent(self.values(by)[-2:], self.values(key)[-2:])

    def points(self, key, by):
        return list(zip(self.values(by), self.values(key)))


class Results:
    def __init__(self, rows):
        self.rows = rows

    def series(self, **names):
        return Series(row for row in self.rows
                      if all(row.get(key) == value for key, value in names.items()))

    def space(self, surface, mesh, potential):
        return self.series(table="space", surface=surface, mesh=mesh, potential=potential)

    def step(self, surface, constraints):
        """On the finest mesh."""
        return self.finest(self.series(table="step", surface=surface, constraints=constraints))

    def unit_time(self, surface, constraints):
        return self.finest(self.series(table="unit time", surface=surface,
                                       constraints=constraints))

    def cases(self, *keys, **names):
        """The different values of some keys, in the order of the rows."""
        return list(dict.fromkeys(tuple(row[key] for key in keys)
                                  for row in self.series(**names)))

    @staticmethod
    def finest(series):
        most = max(row["faces"] for row in series)
        return Series(row for row in series if row["faces"] == most)


def small_steps(series):
    """Those of 1/4 and less, with the distortion above that of the smallest of all steps."""
    return Series(dict(row, q_above=row["q_mean"] - row["q_mean_limit"]) for row in series[2:])


def slopes(series, key, by="h"):
    """Of all meshes, and of the two finest."""
    return f"{series.slope(key, by):.2f} ({series.last_slope(key, by):.2f})"


def space_table(results):
    """The slopes in the edge length of all cases, by the kind of mesh."""
    keys = ["q_mean", "q_p99", "q_max", "ratio_rms", "ratio_max", "shape"]
    lines = []
    for mesh in dict.fromkeys(case[1] for case in results.cases("surface", "mesh", "potential", table="space")):
        found = [results.space(*case)
                 for case in results.cases("surface", "mesh", "potential", table="space", mesh=mesh)]
        lines.append([mesh, str(len(found)), *(extent(series.slope(key, "h") for series in found if key in series[0])
                                               for key in keys)])
    return table(["mesh", "cases", *(NAMES[key] for key in keys)], lines)


def curvature_table(results):
    """Of the result, and of the mesh before."""
    keys = ("curvature", "source_curvature")
    return table(["surface, mesh, rho", "of the result", "of the mesh before"], [
        [", ".join(case), *(f"{series[-1][key]:.1e}, slope {slopes(series, key)}" for key in keys)]
        for case in results.cases("surface", "mesh", "potential", table="space")
        for series in [results.space(*case)] if "curvature" in series[0]])


def verdict(value, wanted, tolerance):
    return f"{value:.3f}", "yes" if abs(value - wanted) <= tolerance else "**no**"


def target_table(results):
    rows = []

    def add(what, wanted, tolerance, value):
        rows.append([what, f"{wanted:.1f} ± {tolerance:g}", *verdict(value, wanted, tolerance)])

    cases = [("sphere", "regular", "smooth"), ("disk, free", "uniform", "bump"),
             ("disk, free", "nonuniform", "bump"), ("torus", "regular", "inversion")]
    for case in cases:
        add(f"Q mean in h: {', '.join(case)}", 1, 0.05, results.space(*case).slope("q_mean", "h"))
    for case in cases:
        add(f"cross-ratio rms in h: {', '.join(case)}", 2, 0.2,
            results.space(*case).slope("ratio_rms", "h"))
    add("Q mean in tau, one step: genus 3", 1, 0.05,
        results.step("genus 3", ADJOINT).slope("q_mean", "tau"))
    limit = small_steps(results.unit_time("genus 3", ADJOINT))
    add("Q mean to the limit in tau, unit time: genus 3", 1, 0.05, limit.slope("q_to_limit", "tau"))
    for surface in ["genus 3", *ANNULI]:
        for constraints, wanted in ((ADJOINT, 2), (NONE, 1)):
            name = "with constraints" if constraints == ADJOINT else "without"
            add(f"gap in tau, one step, {name}: {surface}", wanted, 0.1,
                results.step(surface, constraints).slope("gap", "tau"))
    return table(["what", "wanted slope", "found", ""], rows)


def figure(curves, exponents, by, labels):
    """curves: (name, series, key); dashed lines of some exponents through the last curves' ends."""
    lines = {f"{name} ({series.slope(key, by):.2f})": series.points(key, by)
             for name, series, key in curves}
    every = [x for points in lines.values() for x, _ in points]
    dashed = []
    for exponent_, curve in exponents.items():
        points = curves[curve][1].points(curves[curve][2], by)
        dashed.append(f"slope {exponent_}")
        lines[dashed[-1]] = plot.power(every, 1.6 * max(points)[1], exponent_)
    return plot.curves(lines, *labels, dashed)


def space_figures(results):
    labels = "mean edge length", "means of Q - 1, log length cross-ratio"
    sphere = results.space("sphere", "regular", "smooth")
    disks = [(mesh, results.space("disk, free", mesh, "bump"))
             for mesh in ("uniform", "nonuniform")]
    tori = [(mesh, results.space("torus", mesh, "inversion")) for mesh in ("regular", "irregular")]
    edges = [(mesh, results.space("disk, tangents", mesh, "constant"))
             for mesh in ("irregular", "irregular inside", "uniform")]
    return {
        "convergence_sphere.svg": figure(
            [(NAMES[key], sphere, key) for key in ("q_max", "q_mean", "ratio_max", "ratio_rms")],
            {1: 0, 2: 2}, "h", (labels[0], "Q - 1, log length cross-ratio", "Sphere, smooth potential")),
        "convergence_disk.svg": figure(
            [(f"{name}, {mesh}", series, key)
             for name, key in (("Q", "q_mean"), ("cross-ratio", "ratio_rms"))
             for mesh, series in disks],
            {1: 0, 2: 2}, "h", (*labels, "Disks, a bump, free boundary")),
        "convergence_torus.svg": figure(
            [(f"{name}, {mesh}", series, key)
             for name, key in (("Q", "q_mean"), ("cross-ratio", "ratio_rms"), ("shape", "shape"))
             for mesh, series in tori],
            {1: 0, 2: 2}, "h", (*labels, "Torus, the potential of an inversion")),
        "convergence_boundary.svg": figure(
            [(mesh, series, "ratio_rms") for mesh, series in edges],
            {1: 0, 2: 2}, "h", ("mean edge length", "mean of log length cross-ratio",
                                "Disks between their tangents, constant potential")),
    }


def time_figures(results):
    step, free_step = (results.step("genus 3", name) for name in (ADJOINT, NONE))
    unit, thesis = (small_steps(results.unit_time("genus 3", name)) for name in (ADJOINT, THESIS))
    gaps = [(surface.replace("annulus, ", "") + suffix, results.step(surface, constraints), "gap")
            for constraints, suffix in ((NONE, ", without"), (ADJOINT, ""))
            for surface in ANNULI]
    return {
        "convergence_genus_3.svg": figure(
            [("Q, without", free_step, "q_mean"), ("gap, without", free_step, "gap"),
             ("Q", step, "q_mean"), ("cross-ratio", step, "ratio_rms"),
             ("gap", step, "gap")],
            {1: 0, 2: 4}, "tau", ("time step", "Q - 1, cross-ratio, gap",
                                  "Genus 3, one step, with and without constraints")),
        "convergence_genus_3_time.svg": figure(
            [("Q", unit, "q_mean"), ("cross-ratio", unit, "ratio_rms"),
             ("gap, thesis", thesis, "gap"), ("gap", unit, "gap"),
             ("Q to the limit", unit, "q_to_limit"), ("Q above its limit", unit, "q_above")],
            {1: 4}, "tau", ("time step", "Q - 1, cross-ratio, gap",
                            "Genus 3, from time 0 to 1, with constraints")),
        "convergence_annulus.svg": figure(
            gaps, {1: 0, 2: 3}, "tau",
            ("time step", "gap around the hole", "Annulus, one step, with and without constraints")),
    }


def numbers(results):
    """Of the flow, and of irregular boundaries."""
    unit = small_steps(results.unit_time("genus 3", ADJOINT))
    smallest = min(row["tau"] for row in results.series(table="step"))
    disk = [results.space("disk, tangents", mesh, "constant").slope("ratio_rms", "h")
            for mesh in ("irregular", "irregular inside")]

    def last(constraints, key):
        return " and ".join(f"{row[key]:.1e} at h = {row['h']:.3f}" for row in results.series(
            table="step", surface="genus 3", constraints=constraints, tau=smallest))

    return table(["what", "found"], [
        ["slope of the cross-ratio: irregular boundary, only irregular inside", f"{disk[0]:.2f}, {disk[1]:.2f}"],
        ["Q mean - 1 of the smallest step, with constraints", last(ADJOINT, "q_mean")],
        ["gap of the smallest step, with the thesis' constraints", last(THESIS, "gap")],
        ["slopes in tau from time 0 to 1: Q to the limit, gap, Q above the limit",
         ", ".join(slopes(unit, key, "tau") for key in ("q_to_limit", "gap", "q_above"))]])


def blocks(rows):
    results = Results(rows)
    return {"targets": target_table(results), "space": space_table(results), "curvature": curvature_table(results),
            "numbers": numbers(results)}


def figures(rows):
    return {**space_figures(Results(rows)), **time_figures(Results(rows))}
