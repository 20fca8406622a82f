#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Strings beads on a ring: a torus whose mean curvature is changed by rings of rho.

usage: first_picture.py [OUTPUT.ply [PICTURE.png]]

The picture needs matplotlib. For a mesh of your own: ``V, F = mesh.vertices, mesh.faces`` with
trimesh, ``mesh.points, mesh.cells_dict["triangle"]`` with meshio.
"""

import sys

import numpy as np

import conformal_geometry as cg


def ring(around, across, radius=3.):
    """A torus as arrays: V, n x 3, F, m x 3, and the angle of each vertex around the axis."""
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * i / around, 2 * np.pi * j / across
    r = radius + np.cos(b)
    V = np.stack([r * np.cos(a), r * np.sin(a), np.sin(b)], axis=-1).reshape(-1, 3)
    at = lambda k, l: k % around * across + l % across
    F = np.concatenate([np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], axis=-1),
                        np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], axis=-1)])
    return V, F.reshape(-1, 3), a.ravel()


def write_ply(path, V, F):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"ply\nformat ascii 1.0\nelement vertex {len(V)}\nproperty double x\n"
                   f"property double y\nproperty double z\nelement face {len(F)}\n"
                   "property list uchar int vertex_indices\nend_header\n")
        np.savetxt(file, V, fmt="%.17g")
        np.savetxt(file, np.column_stack([np.full(len(F), 3), F]), fmt="%d")


def picture(surfaces, F, values, zoom=1.4):
    """A figure with the surfaces side by side, coloured by values per vertex: red where positive."""
    from matplotlib import cm, colors, pyplot

    figure = pyplot.figure(figsize=(5 * len(surfaces), 4))
    bound = np.abs(values).max()
    tones = cm.coolwarm(colors.Normalize(-bound, bound)(values[F].mean(axis=1)))
    for k, V in enumerate(surfaces):
        axes = figure.add_subplot(1, len(surfaces), k + 1, projection="3d", proj_type="ortho")
        normals = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        light = .35 + .65 * np.clip(normals @ np.array([.3, -.5, .81]), 0, 1)
        mesh = axes.plot_trisurf(*V.T, triangles=F, linewidth=0, antialiased=False)
        mesh.set_facecolors(tones * np.column_stack([light, light, light, np.ones(len(F))]))
        axes.set_box_aspect(np.maximum(np.ptp(V, axis=0), 1e-3), zoom=zoom)
        axes.view_init(45, -60)
        axes.set_axis_off()
    figure.subplots_adjust(0, 0, 1, 1, 0, 0)
    return figure


def main(output="first_picture.ply", picture_file=None):
    V, F, angle = ring(180, 36)
    rho = 1.2 * np.sin(9 * angle)                         # the change of mean curvature, in 1/length
    result = cg.spin_transform(V, F, rho)                 # lengths change by a factor of 2 at most
    print(result.report)                                  # the certificate
    if not result:
        sys.exit(result.report.fault)
    write_ply(output, result.positions, F)
    if picture_file:
        picture([V, result.positions], F, rho).savefig(picture_file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
