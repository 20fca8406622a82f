# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The operators of the thesis as sparse matrices of SciPy, and a few measures.

A quaternionic matrix is a real one with blocks of 4 x 4 numbers, for left multiplication: it acts
on ``spins.ravel()``, with (w, x, y, z) of each vertex one after the other.
"""

from __future__ import annotations

from typing import Optional, Tuple

import numpy as np
from scipy.sparse import bsr_matrix, coo_matrix, csr_matrix

from . import _kernels
from ._arrays import faces, points, real_or_none
from ._types import Faces, Points, Value_array, Values


def _blocks(q: np.ndarray) -> np.ndarray:
    """Left multiplication by the rows (w, x, y, z), one matrix each."""
    w, x, y, z = q.T
    return np.array([[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]]
                    ).transpose(2, 0, 1)


def _quaternionic(entries: Tuple[np.ndarray, np.ndarray, np.ndarray], rows: int, columns: int
                  ) -> bsr_matrix:
    i, j, values = entries
    order = np.lexsort((j, i))
    starts = np.zeros(rows + 1, dtype=np.int64)
    starts[1:] = np.cumsum(np.bincount(i, minlength=rows))
    blocks = _blocks(values.reshape(-1, 4)[order])
    return bsr_matrix((blocks, j[order], starts), shape=(4 * rows, 4 * columns))


def dirac_operator(V: Points, F: Faces) -> bsr_matrix:
    """D, 4m x 4n: the quaternionic Dirac operator [CGP (5.1)], in 1/length. D f = -2 N on every
    face, and constants are in its kernel."""
    name = "dirac_operator"
    V, F = points(V, name), faces(F, name)
    return _quaternionic(_kernels.dirac_operator(V, F), len(F), len(V))


def dirac_energy(V: Points, F: Faces, rho: Optional[Values] = None, *, on: Optional[str] = None) -> bsr_matrix:
    """X = (D - R)^H M (D - R), 4n x 4n: symmetric, positive semidefinite, dimensionless
    [CGP Alg. 2]; rho as in ``spin_transform()``, by default 0."""
    name = "dirac_energy"
    V, F = points(V, name), faces(F, name)
    rho = real_or_none(rho, name, "values of rho")
    return _quaternionic(_kernels.dirac_energy(V, F, rho, on or ""), len(V), len(V))


def cotan_laplacian(V: Points, F: Faces) -> csr_matrix:
    """L, n x n: symmetric, positive semidefinite, with the constants as kernel; dimensionless
    [CGP 5.6]. (L u)_i = sum of w_ij (u_i - u_j), w_ij = (cot a + cot b) / 2."""
    name = "cotan_laplacian"
    V = points(V, name)
    i, j, values = _kernels.cotan_laplacian(V, faces(F, name))
    return coo_matrix((values, (i, j)), shape=(len(V), len(V))).tocsr()


def vertex_areas(V: Points, F: Faces) -> Value_array:
    """M_V, (n,): a third of the area of the faces around each vertex, in length^2 [CGP 5.4]."""
    return _kernels.vertex_areas(points(V, "vertex_areas"), faces(F, "vertex_areas"))


def face_areas(V: Points, F: Faces) -> Value_array:
    """M_F, (m,): the areas of the faces, in length^2 [CGP 5.4]."""
    return _kernels.face_areas(points(V, "face_areas"), faces(F, "face_areas"))


def mean_curvature(V: Points, F: Faces) -> Value_array:
    """H at the vertices, (n,), in 1/length: +1 on the unit sphere with normals outward, from
    Delta f = 2 H N with mixed Voronoi areas."""
    return _kernels.mean_curvature(points(V, "mean_curvature"), faces(F, "mean_curvature"))


def quasi_conformal_errors(V: Points, F: Faces, moved: Points) -> Value_array:
    """Q >= 1 of each face, (m,): the ratio of the singular values of the map to the vertices
    ``moved``, n x 3; 1 where it is a similarity [CGP 5.8.1]."""
    name = "quasi_conformal_errors"
    return _kernels.quasi_conformal_errors(points(V, name), faces(F, name), points(moved, name))
