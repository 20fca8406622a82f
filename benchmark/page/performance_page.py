# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/performance.md and its figures, made of measurements."""

from page import plot, tables
from page.measurements import bytes_per_vertex, is_sphere, title

TEXT = """\
# The solvers, measured

Written by `benchmark/performance` with `benchmark_solvers`; run it on your machine to compare.
The measurements are in performance.jsonl beside this page, one row a line.

{machine}

**P** is the yardstick: one scalar Poisson problem on the same mesh by CHOLMOD, called directly and
left to its own choices but for the number of threads, one: assembly of the cotan Laplacian,
ordering and analysis, factorization, one solve with three right-hand sides. It is measured in turn
with every row, in the process of that row. Times are seconds of the processor on one thread, the
best of several runs; wall clock where threads are compared. Memory is the peak of the first run
above the mesh, in a fresh process.

Meshes have area 4 pi. The spheres have bumps of a tenth of their radius, the others are from CGAL
(Debian's package libcgal-demo). rho is
*amplitude* (sin(3x + 1/2) cos 2y + 0.6 sin(4z + x)), less its mean, at the centroids of the faces,
with amplitude 1: the unit is 1/R, R the radius of the sphere of the same area. 1 is an edit that
one sees, 3 a strong one. The eigenvector is computed to an error of 1e-6.

## Targets

{met} of {measured} targets are met, of {all} in all. The worst mesh counts.

{targets}

## Why targets are missed

Microseconds per vertex of *native, float*, the default, with amplitude 1, and of its yardstick:

{costs}

- **P depends on the BLAS.** CHOLMOD's dense kernels are those of OpenBLAS, which differ much from one
  processor to the next; the library's are its own. On an AMD EPYC, where P took about twice as long
  and the library, up to 131k faces, as long as here, the ratios of this page were half as large.
- **P is cheap on limbs.** Where a surface branches into limbs, such as bull, CHOLMOD's factor has
  little fill, and P costs two thirds of what it does on a sphere of as many vertices; checks and
  ordering (*setup*), positions and certificate cost about the same everywhere, and on bull are worth
  nearly 2 P.
- **Rho that is strong for the surface.** Along a limb lambda grows exponentially with rho: one
  vector does not become the other by small corrections, so the branch is followed in stages, a
  factorization and a few solves each. A result that collapses is refused at its end: that a stage
  on the way exceeds a limit does not prove that the end will. (With a bound on lengths, it is given
  up where they change by more than the square of it; the rho' that is looked for then is another.)
- **With a bound on lengths** the spins are computed for ten to fifty rho', a factorization each, and
  each step solves a linear system in rho, with about ten products of two solves. Where limbs make
  the next eigenvalues come near, lambda is far from linear in rho: its derivative is useless after a
  hundredth of a step, and a span of six vectors, in which the length of a step is chosen, shows how
  short the good steps are. Correcting steps to second order within that span, and bounding the
  lengths directly instead of weighting their squares, were tried: the first does not make them
  longer, the second takes three times the products.
- **A later step of a flow** factors X and the Laplacian anew, measures the surface and certifies
  it; only ordering and analysis are saved.
- **Surfaces with handles** need a second quaternionic factorization, of X for rho = 0, and about five
  solves with it for each period (*exactness*): half of the time. One factor does not do for both: with
  the other one, rho of amplitudes .25 to 1 takes 6 to 280 iterations instead of 3 to 6, a period 9 to 49
  instead of 3 to 5 (`benchmark_shared_factor` on eight, elephant, refined_elephant, knot1, rotor, bear).
- **Spectra** need about a hundred vectors; orthogonalizing them costs as much as the solves. Fewer
  pairs than seventeen to twenty at first take a tenth less on most meshes and twice as much on others,
  where more have to be found then (bull, for five and for thirty eigenvalues).
- **Memory that is new** has to be cleared by the system, which is dear on virtual machines, for large
  meshes and in P as well. With `MALLOC_TRIM_THRESHOLD_` and `MALLOC_MMAP_THRESHOLD_` of 2000000000
  (glibc), freed memory is kept.
- **Two threads**: all that loops over sheets, rows or vectors is divided between them, with the same
  bits. Minimum degree ordering and symbolic analysis are not, a tenth to a fifth of a transformation;
  on surfaces of less than 10,000 vertices the parts are too short, because a thread takes
  20 to 40 microseconds to wake up.
- **Multigrid** wins on large spheres only: on every scan it takes many times the iterations, and
  more time than the direct solver. It is therefore never chosen automatically.

## Time and memory

![time of the first transformation](figures/performance_time.svg)

![memory of the first transformation](figures/performance_memory.svg)

Exponents in the number of vertices, fitted to the spheres with all sizes, from 131k and from 0.5M
faces:

{exponents}

The implementation that came with the thesis in 2011, as measured on such a machine, and *native,
double*:

{original}

## First transformations

The whole of `Spin_transformation` on a mesh never seen before: checks, pattern, ordering, analysis,
factorizations, eigenvector, positions and certificate. *Factorizations* are those of X, *solves*
those with their factors, *iterations* those of the eigensolver. *Difference* is the largest distance
to the positions of *native, double* at tolerance 1e-12, after the best similarity, relative to
the bounding box. The stages are shares of the total; *setup* has the checks, the ordering and
the analysis, *exactness* what keeps handles closed, *reconstruction* the factor of the Laplacian.

*Native, float* is the default of the library: the factor of X, which only guides iterations in
double precision, is in single precision where that suffices; *native, double* has it in double
precision. *Thesis recipe* is what a careful user of other libraries writes: X in real numbers, 4n x 4n, by
triplets (lower triangle only), `Eigen::CholmodSupernodalLLT`, three steps of the inverse power
method from lambda = 1, and the Poisson problem by the same means; no checks, no certificate, and
an error that nobody knows. *CHOLMOD, complex 2n* and *native, inverse power method* are this
library with one part replaced.

{transforms}

## Edits of several strengths

All closed surfaces of genus 0 among CGAL's meshes with more than 5,000 faces, in units of P, with
the default solvers, and the numbers of factorizations and solves. A result that does not verify, which the
report says, has an asterisk: so strong an edit collapses or folds these surfaces without control
of scale.

{strengths}

The same with control of scale, `scale_bound(2)`, as the program does it: the nearest rho whose factors
of lengths are within [1/2, 2] on 98 % of the area. *Kept* is its norm relative to that of rho.

{bounded}

## Later steps of a flow

Willmore flow with rho = -tau H on the vertices: the mean of the steps 2 to 5, from curvature to
certificate, on one `Spin_transformation` that is given new positions. *tau* is the largest of 0.3,
0.15, ... with which all five steps are verified: thin limbs allow shorter steps only. Both matrices are factored in
every step: a solver that kept a factor for several steps, and iterated with it, was slower on all
meshes but the largest sphere. *Factorizations* are those of X per step.

{flows}

## Spectra

The ten eigenvalues nearest to zero of D, and of D - rho with rho of amplitude 1, on a mesh never
seen before, to residuals of 1e-8: `Dirac_spectral_problem`, as `conformal spectrum` calls it. X is
factored once, in double precision; about a hundred vectors are made, each with a solve, and
orthogonal to all before it. Seventeen to twenty pairs are found, so that none of the ten is
missing, and some twenty vectors then look for copies. *Complete*: the report says so.

{spectra}

## Two threads

Wall clock.

{threads}

## Factorizations

Each model with the ordering that it chooses by itself. *Again* is a second factorization into the
same memory, as flows do; its ratio is to the same of CHOLMOD on the scalar Laplacian. *Solve* is
one quaternionic right-hand side, or three real ones; *bytes/vertex* are those of the factor.

{factors}
"""


def headed(m, table_of, kind):
    """One table per mesh, under its name."""
    parts = []
    for mesh, faces, vertices in m.meshes():
        rows = m.rows(kind, mesh=mesh)
        if rows:
            parts.append(f"**{title(mesh)}**: {faces:,} faces, {vertices:,} vertices\n\n"
                         + table_of(m, mesh))
    return "\n\n".join(parts)


def page(m, machine):
    targets, met, measured = tables.target_table(m)
    return TEXT.format(
        machine=machine, targets=targets, met=met, measured=measured,
        all=len(tables.targets.TARGETS), exponents=tables.exponent_table(m),
        costs=tables.cost_table(m),
        original=tables.original_table(m),
        transforms=headed(m, tables.transform_table, "transform"), flows=tables.flow_table(m),
        spectra=tables.spectrum_table(m),
        strengths=tables.strength_table(m),
        bounded=tables.strength_table(m, "bounded"),
        threads=tables.thread_table(m),
        factors=headed(m, tables.factor_table, "factor"))


def figures(m):
    """file name -> SVG"""
    rows = [row for row in m.measured("poisson") + m.measured("transform")
            if is_sphere(row["mesh"])]
    time, memory = {}, {}
    for row in rows:
        name = "P" if row["table"] == "poisson" else row["model"]
        time.setdefault(name, []).append((row["faces"], row["seconds"]))
        memory.setdefault(name, []).append((row["faces"], bytes_per_vertex(row)))
    if not rows:
        return {}
    return {"performance_time.svg": plot.log_log(
                time, "faces", "seconds", "First transformation of a bumpy sphere: time"),
            "performance_memory.svg": plot.log_log(
                memory, "faces", "bytes per vertex",
                "First transformation of a bumpy sphere: peak memory above the mesh")}
