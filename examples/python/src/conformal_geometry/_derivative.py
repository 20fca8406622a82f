# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The derivative of spin transformations, for optimization and for learning."""

from __future__ import annotations

from typing import Any, Callable, Optional

import numpy as np
from scipy.sparse.linalg import LinearOperator

from . import _kernels
from ._arrays import faces, points, real
from ._boundary import Boundary_condition
from ._types import Changes, Faces, Points, Values


class Spin_derivative:
    """The exact derivative of the transformation by rho, at a rho, and its transpose: a few solves
    with one factor for each product [CGP 5.7; linearization of (5.3)].

    ``spins``, ``log_scales`` and ``positions`` are operators of SciPy: with d one of them,
    ``d @ drho`` is the change of the result, and ``d.T @ y`` the gradient of the function whose
    gradient with respect to the result is y; both take several columns. Rows are those of the
    flattened arrays: ``(d.positions @ drho).reshape(-1, 3)`` is the velocity of the vertices.

    - positions: of the result, with constant area and centroid; in units of length;
    - log_scales: of log |lambda|^2, the logarithms of the factors of lengths, less their mean;
    - spins: of lambda with constant mean square, orthogonal to lambda, for constant factors from
      the right only turn the surface; y is projected likewise.

    The transformation is that by ``max_scale=None``, in one step. The parameters are those of
    ``spin_transform()``; prescribed positions are refused. Not differentiable where two
    eigenvalues meet.

    Raises
    ------
    Solver_error
        if the equation is not solved, or the iterations for a product do not converge
    """

    def __init__(self, V: Points, F: Faces, rho: Values, *, on: Optional[str] = None,
                 tolerance: float = 1e-12, boundary: Optional[Boundary_condition] = None,
                 mollification: Optional[float] = None) -> None:
        name = "Spin_derivative"
        kernel = _kernels.Derivative(
            points(V, name), faces(F, name), real(rho, name, "values of rho"), on or "",
            dict(boundary=boundary, mollification=mollification, max_scale=None),
            dict(tolerance=tolerance))
        inputs = kernel.inputs()
        masses = kernel.masses()
        n = len(masses)

        def centred(u: np.ndarray) -> np.ndarray:
            return u - (masses.T @ u) / masses.sum()

        def centred_transpose(y: np.ndarray) -> np.ndarray:
            return y - masses * (y.sum(axis=0) / masses.sum())

        self.spins = _operator((4 * n, inputs), kernel.spins, kernel.spins_transpose)
        self.log_scales = _operator(
            (n, inputs), lambda x: centred(kernel.log_scales(x)),
            lambda y: kernel.log_scales_transpose(centred_transpose(y)))
        self.positions = _operator((3 * n, inputs), kernel.positions, kernel.positions_transpose)
        self._kernel = kernel

    def eigenvalue_change(self, drho: Changes) -> np.ndarray:
        """The change of gamma, which is a number, or one for each column; 0 where the surface has a
        boundary, and with it no eigenvalue."""
        drho = real(drho, "Spin_derivative", "values")
        change = self._kernel.eigenvalue(drho)[0]
        return change[0] if drho.ndim == 1 else change


def _operator(shape: Any, apply: Callable[[np.ndarray], np.ndarray],
              apply_transpose: Callable[[np.ndarray], np.ndarray]) -> LinearOperator:
    def block(function: Callable[[np.ndarray], np.ndarray]) -> Callable[[Any], np.ndarray]:
        return lambda x: function(real(x, "Spin_derivative", "values"))

    def column(function: Callable[[np.ndarray], np.ndarray]) -> Callable[[Any], np.ndarray]:
        return lambda x: block(function)(np.reshape(x, (-1, 1)))[:, 0]

    return LinearOperator(shape, matvec=column(apply), rmatvec=column(apply_transpose),
                          matmat=block(apply), rmatmat=block(apply_transpose), dtype=np.float64)
