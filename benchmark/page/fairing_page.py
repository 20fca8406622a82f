# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/fairing.md and its plots, made of the rows that benchmark_fairing prints."""

import math

from page import machine, plot

SPHERE = 4 * math.pi
FAITHFUL = 1.1  # Q mean below this
DRAWN = {"before": "before", "explicit_mean_curvature_stable": "explicit mean curvature",
         "implicit_mean_curvature_stable": "implicit mean curvature",
         "modified_mean_curvature_stable": "modified mean curvature",
         "discrete_Willmore,_16_fold_stable": "discrete Willmore, 16 fold",
         "isometric_bending_stable": "isometric bending", "ours_default": "ours"}
SHAPES = {
    "uniform": "*blobby* of CGAL's data, subdivided once by Loop's rule",
    "irregular": "the same surface, subdivided twice, less three quarters of its faces: edges drawn "
                 "by lot have collapsed into one of their ends, unless an angle came out above 150 "
                 "degrees",
    "slivers": "the same without a bound for angles"}

TEXT = """\
# Fairing methods compared

Written by `benchmark/compare_fairing` from one run of `benchmark_fairing` on

- processor: {processor}

This is the comparison of [CGP 6.4.6] with today's solvers: which method makes a surface smooth in a
given time, and what becomes of its triangles. `benchmark_fairing --check` compares every method with
what is known of it in closed form.

## What is compared

L is the cotan Laplacian, M the mixed Voronoi areas, both of the surface before the step; L_0 is that of
the input. t is the time step.

| method | one step | system |
|---|---|---|
| explicit mean curvature [Bra92] | f - t/2 M^-1 L f | none |
| explicit bi-Laplacian [Tau95] | f - t/2 (M^-1 L)^2 f | none |
| implicit mean curvature [DMSB99] | (M + t/2 L) f' = M f | factorized in every step |
| implicit bi-Laplacian | (M + t/2 L M^-1 L) f' = M f | factorized in every step |
| modified mean curvature [KSBC12] | (M + t/2 L_0) f' = M f, barycentric M | factorized in every step |
| smooth_shape of CGAL | the same, with that time step; `CGAL::Polygon_mesh_processing::smooth_shape()` | factorized in every step |
| volume-controlled mean curvature [EPT+07] | (M + t/2 L) f' = M f + c A, A the gradient of the volume, c such that it stays | factorized in every step |
| discrete Willmore [BS05] | (M + t/2 L M^-1 L) (f' - f) = -t grad W, W the energy of circle angles | factorized in every step |
| discrete Willmore, 16 fold | the same with 16 t/2 L M^-1 L for the Hessian, which W outgrows where circles nearly coincide | factorized in every step |
| isometric bending [WBH+07] | (M + t/2 Q) f' = M f, f^T Q f the bending energy of hinges | factorized in every step |
| isometric bending, metric kept | the same with M and Q of the input | factorized once |
| ours | rho = -t H, `Conformal_willmore_flow` without its exact class, as in the thesis, else with default options: t = 1, half of it where that is too large | quaternionic, factorized in every step |
| ours, one time step | the same without trying again | the same |

- *Equal solver*: all matrices are symmetric and positive definite, and all are factorized by the
  supernodal Cholesky factorization of this library, smooth_shape's too: in real numbers for the others, in
  quaternions for ours. Ordering and symbolic analysis are done once.
- *Equal time*: seconds of the processor on one thread, from the arrays of the mesh on, without what only
  measures. All have the seconds that ours takes with these options until its energy settles, at most
  20 steps; a step that ends later does not count.
- *Largest stable time step*: of 64, 32, 16, ..., the first with which, through all that time, every number is
  finite, every system is solved, and the Willmore energy is never more than 1 % above the least so far; then
  the square root of 2 times that is tried. Mean curvature flows do not descend the Willmore energy; a second
  table has, for every method, the time step tried that ends with the least energy, stable or not.
- *Scale*: the meshes have area 4 pi. After each step the surface is scaled to that area, which no
  measure sees; without, most flows would shrink it to a point.

*E* is the Willmore energy by 4 pi, 1 for the sphere, up to an error of second order, so it may be slightly less;
*by angles* the same by bending angles instead of cotangents (Steiner's formula), as a second opinion.
*Q* is the quasi-conformal error of the map from the input (1 is perfect, the mean is weighted by area), *on
the way* the greatest Q mean of all moments until then,
*cross-ratio* the root mean square change of the logarithm of the length cross-ratios, *angle* the least angle of any
face in degrees, *flips* the faces that are turned over or have no area.

{meshes}

## Verdict

Computed from the tables, of ours with these options:

{verdict}

{comment}
"""

COMMENT = """\
- Where only the end counts, the modified mean curvature flow is hard to beat on surfaces without handles: it
  runs into the conformal map to the sphere, steps are cheap and may be large, and nothing sums up. What lies between
  is sheared (*on the way*), and it goes to spheres only; who wants a surface that is smoother and not a
  sphere, or handles, or angles kept at any moment, has to take another one.
- The explicit methods shear little because they move little: their time step is of second and fourth order
  in the shortest edge, and thin triangles take the rest. *Isometric bending* and *discrete Willmore* suffer
  from the same where triangles are thin.
- Implicit mean curvature and implicit bi-Laplacian end on spheres too, with triangles that no longer
  have to do with those of the input.
- Ours keeps angles throughout, and its time step does not depend on the mesh, as long as the mean
  curvature of the mesh is that of the surface. Where angles near 180 degrees make it noise, as in *slivers*,
  no step lowers the energy for long: the surface is round on the whole (picture), but the noise stays, the
  flow stops and says so. Remesh, or flip edges, before.
- A measure of one discretization favours methods that descend just that, so the energy is also given by
  angles. Spheres differ from 1 in either by an error of second order in the edge length; differences as
  small as that do not tell a winner."""

HEAD = ["method", "t", "stable", "steps", "seconds", "E", "by angles", "Q mean", "on the way", "Q p99",
        "Q max", "cross-ratio", "angle", "flips", "end"]


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


def line(cells):
    return "| " + " | ".join(cells) + " |"


def is_moved(row):
    return row["steps"] > 0


def cells(row):
    if not is_moved(row):
        return [row["method"], *["none"] * 2, *[""] * 11, row["end"]]
    return [row["method"], f"{row['time_step']:.2g}", "yes" if row["stable"] else "no",
            f"{row['steps']:,}", f"{row['seconds']:.2f}", energy(row),
            number(row["steiner_energy"] and row["steiner_energy"] / SPHERE, ".4f"),
            number(row["q_mean"], ".4f"), number(row["q_worst"], ".4f"),
            number(row["q_p99"], ".3f"), number(row["q_max"], ".3g"),
            number(row["cross_ratio_rms"], ".4f"), number(row["least_angle"], ".3f"),
            str(row["flips"]), row["end"]]


def energy(row):
    return number(row["energy"] and row["energy"] / SPHERE, ".4f")


def table(rows):
    return "\n".join([line(HEAD), "|---" + "|--:" * (len(HEAD) - 2) + "|---|",
                      *(line(cells(row)) for row in rows)])


def section(rows, mesh, drawn):
    before = next(row for row in rows if row["mesh"] == mesh and row["method"] == "before")
    return "\n\n".join([
        f"## {mesh}: {SHAPES[mesh]}",
        f"{before['faces']:,} faces; E = {energy(before)}, by angles "
        f"{before['steiner_energy'] / SPHERE:.4f}; least angle {before['least_angle']:.3f} degrees. "
        f"Time: {of_role(rows, mesh, 'default')[0]['budget']:.2f} seconds.",
        f"![energy against time on the mesh {mesh}](figures/fairing_{mesh}.svg)",
        f"![what has become of {mesh}](figures/fairing_{mesh}.png)",
        f"*Largest stable time step, when time is up: {', '.join(drawn)}.*",
        "Each with its largest stable time step:", table(of_role(rows, mesh, "stable")),
        "Each with the time step that ends lowest:", table(of_role(rows, mesh, "lowest"))])


def plot_of(rows, mesh):
    """E - 1 has no logarithm where E is less than 1, so it is E that is drawn."""
    lines = {row["method"]: [tuple(map(float, moment.split(":"))) for moment in row["curve"].split()]
             for row in of_role(rows, mesh, "stable") if is_moved(row)}
    lines = {name.replace("mean curvature", "mean curv."):
             [(seconds, value / SPHERE) for seconds, value in points if seconds > 0]
             for name, points in lines.items()}
    return plot.log_log(lines, "seconds of the processor", "Willmore energy / 4 pi",
                        f"{mesh}: largest stable time steps")


def keeps(key):
    return lambda row: is_moved(row) and row[key] is not None and row[key] < FAITHFUL


def judgement(ours, rivals):
    shown = ", ".join(f"{row['method']} {energy(row)} (Q mean {row['q_mean']:.4f}, on the way "
                      f"{row['q_worst']:.4f})" for row in rivals[:3])
    own = f"E = {energy(ours)} (Q mean {ours['q_mean']:.4f}, on the way {ours['q_worst']:.4f})"
    if not rivals:
        return f"ours alone, with {own}."
    place = "ends lowest" if ours["energy"] < rivals[0]["energy"] else "does **not** end lowest"
    return f"ours {place} of {len(rivals) + 1}, with {own}; of the others: {shown}."


def sentence(rows, mesh, role, key):
    ours = of_role(rows, mesh, "default")[0]
    others = [row for row in of_role(rows, mesh, role) if "ours" not in row["method"]]
    rivals = sorted(filter(keeps(key), others), key=lambda row: row["energy"])
    if keeps(key)(ours):
        return judgement(ours, rivals)
    best = f"; the lowest that does is {rivals[0]['method']}, {energy(rivals[0])}" if rivals else ""
    return f"ours does **not**: it has {ours[key]:.4f}, and ends with E = {energy(ours)}{best}."


def verdict(rows):
    return "\n".join(
        f"- *{mesh}*, {what}, methods that keep Q mean below {FAITHFUL} {when}: "
        f"{sentence(rows, mesh, role, key)}"
        for mesh in meshes(rows)
        for role, what in (("stable", "largest stable time steps"),
                           ("lowest", "time steps that end lowest"))
        for key, when in (("q_worst", "throughout"), ("q_mean", "at the end")))


def text(rows, drawn):
    sections = "\n\n".join(section(rows, mesh, drawn[mesh]) for mesh in meshes(rows))
    return TEXT.format(processor=machine.processor(), meshes=sections, verdict=verdict(rows),
                       comment=COMMENT)
