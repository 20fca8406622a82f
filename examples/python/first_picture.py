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
from conformal_geometry.pictures import picture, ring


def write_ply(path, V, F):
    with open(path, "w", encoding="ascii") as file:
        file.write(f"ply\nformat ascii 1.0\nelement vertex {len(V)}\nproperty double x\n"
                   f"property double y\nproperty double z\nelement face {len(F)}\n"
                   "property list uchar int vertex_indices\nend_header\n")
        np.savetxt(file, V, fmt="%.17g")
        np.savetxt(file, np.column_stack([np.full(len(F), 3), F]), fmt="%d")


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
