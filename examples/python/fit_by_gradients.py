#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Finds the change of mean curvature that leads to a surface of given curvature, by 50 gradient
steps: spin transformations are differentiable, so they can be layers of any optimisation.

usage: fit_by_gradients.py

The energy is half of the squared difference of L f / A, twice the mean curvature normals where the
metric is that of the sphere. Its gradient by rho takes one product with the transpose of the
derivative, a few solves with the factor at hand. Steps have the length of Barzilai and Borwein.
"""

import numpy as np
from scipy.spatial import ConvexHull

import conformal_geometry as cg


def spun(V, F, rho):
    """The positions without a bound on lengths: these are what `Spin_derivative` differentiates."""
    return cg.spin_transform(V, F, rho, on="vertices", max_scale=None).positions


def fit(V, F, target, steps=50):
    """The best rho, and the energies before each step, relative to the first."""
    masses, laplacian = cg.vertex_areas(V, F), cg.cotan_laplacian(V, F)
    rho, best, energies, last = np.zeros(len(V)), None, [], None
    for _ in range(steps):
        miss = laplacian @ (spun(V, F, rho) - target)
        energies.append((miss ** 2 / masses[:, None]).sum() / 2)
        if energies[-1] == min(energies):
            best = rho
        positions = cg.Spin_derivative(V, F, rho, on="vertices", tolerance=1e-6).positions
        gradient = positions.T @ (laplacian @ (miss / masses[:, None])).ravel() / masses
        length = .1
        if last is not None:
            d, dg = rho - last[0], gradient - last[1]
            length = abs((masses * d) @ dg) / ((masses * dg) @ dg)
        last = rho, gradient
        rho = rho - length * gradient
    return best, np.array(energies) / energies[0]


def sphere(count):
    """A sphere as arrays: the convex hull of a spiral of points."""
    k = np.arange(count)
    z, angle = 1 - (2 * k + 1) / count, np.pi * (1 + 5 ** .5) * k
    r = np.sqrt(1 - z ** 2)
    V = np.column_stack([r * np.cos(angle), r * np.sin(angle), z])
    F = ConvexHull(V).simplices
    inward = np.linalg.det(V[F]) < 0
    F[inward] = F[inward][:, ::-1]
    return V, F


def main():
    V, F = sphere(1000)
    target = spun(V, F, np.sin(3 * V[:, 1]) + .5 * V[:, 0] * V[:, 2])
    for step, energy in enumerate(fit(V, F, target)[1]):
        print(f"step {step:2}: energy {energy:.2e}")


if __name__ == "__main__":
    main()
