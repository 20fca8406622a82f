# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Spin transformations: surfaces with a prescribed change of their mean curvature."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Dict, NamedTuple, Optional

import numpy as np

from . import _kernels
from ._arrays import faces, points, real, real_or_none
from ._boundary import Boundary_condition
from ._derivative import Spin_derivative
from ._kernels import default_max_scale
from ._report import Result, build
from ._reports import Spin_report, known
from ._types import Faces, Point_array, Points, Quaternion_array, Quaternions, Values, Vertex_values


class Progress(NamedTuple):
    """Where the iteration of the eigensolver is, for callbacks."""
    iteration: int  #: of the present solve
    value: float  #: the approximation of the smallest eigenvalue
    estimate: float  #: of its error


@dataclass(frozen=True, eq=False)
class Spin_result(Result):
    """A transformed surface with the report that verifies it.

    True if the surface is what was asked for; ``report.fault`` says otherwise why not, and the
    arrays are what was found all the same, to be looked at. They have no rows if the computation
    was cancelled.
    """
    positions: Point_array  #: n x 3, in the unit of the mesh
    spins: Quaternion_array  #: n x 4, lambda as (w, x, y, z); df~ = conjugate(lambda) df lambda
    report: Spin_report


Callback = Optional[Callable[[Progress], Optional[bool]]]


def _progress(callback: Callback) -> Optional[Callable[[int, float, float], Optional[bool]]]:
    if callback is None:
        return None
    call = callback
    return lambda iteration, value, estimate: call(Progress(iteration, value, estimate))


def scale_bound(max_scale: Optional[float]) -> Dict[str, Optional[float]]:
    """The option max_scale, none for the default: then the kernels choose, as for all callers."""
    return {} if max_scale is default_max_scale else {"max_scale": max_scale}


def spin_result(positions: Point_array, spins: np.ndarray, report: Dict[str, Any]) -> Spin_result:
    return Spin_result(positions, spins, build(Spin_report, report))


@dataclass(frozen=True)
class Dirac_options:
    """How the eigenvector is found, which there is only without a bound on lengths."""
    max_substeps: int = 10  #: in which a strong rho is applied, each with a factorization
    eigenproblem: str = "standard"  #: or "generalized" [CGP (5.2)]: rho on faces, closed surfaces
    kernel_tolerance: float = 0.  #: with directions: singular values of D - rho that count as zero
    branch: str = "nearest"  #: or "smallest", "zero": which singular vector of D - rho is taken


class Spin_transformation:
    """Many edits of one mesh: what depends on the mesh alone is computed once.

    The parameters are those of ``spin_transform()``; the mesh is copied. An object is used by one
    thread at a time; different objects compute at the same time.
    """

    def __init__(self, V: Points, F: Faces, *, boundary: Optional[Boundary_condition] = None,
                 max_scale: Optional[float] = default_max_scale, vertex_scale: Optional[Vertex_values] = None,
                 vertex_scale_weight: Optional[Vertex_values] = None, exactness: Optional[str] = "adjoint",
                 max_period_defect: Optional[float] = None,
                 mollification: Optional[float] = None, exact_conformal_class: bool = False,
                 function: str = "Spin_transformation") -> None:
        self._function = function
        self._faces = faces(F, function)
        self._boundary, self._mollification = boundary, mollification
        options = dict(
            boundary=boundary, exactness=exactness, **scale_bound(max_scale),
            vertex_scale=real_or_none(vertex_scale, function, "vertex_scale"),
            vertex_scale_weight=real_or_none(vertex_scale_weight, function, "vertex_scale_weight"),
            max_period_defect=max_period_defect, mollification=mollification,
            exact_conformal_class=exact_conformal_class)
        self._kernel = _kernels.Transformation(points(V, function), self._faces, options,
                                               function)

    @property
    def positions(self) -> np.ndarray:
        """The positions of the mesh, n x 3 (a copy); assign others to move it."""
        return self._kernel.positions()

    @positions.setter
    def positions(self, V: Points) -> None:
        self._kernel.set_positions(points(V, self._function))

    def transform(self, rho: Values, *, on: Optional[str] = None, tolerance: float = 1e-8,
                  max_iterations: int = 200, random_seed: int = 0,
                  dirac: Dirac_options = Dirac_options(),
                  limits: Optional[Dict[str, float]] = None,
                  callback: Callback = None) -> Spin_result:
        """The surface whose mean curvature is changed by rho; the object stays as it is."""
        options = dict(vars(dirac), tolerance=tolerance, max_iterations=max_iterations,
                       random_seed=random_seed)
        return spin_result(*self._kernel.transform(
            real(rho, self._function, "values of rho"), on or "", options, known(limits),
            _progress(callback)))

    def integrate(self, spins: Quaternions) -> Spin_result:
        """The surface with given spins, n x 4, whether they are those of a surface or not:
        ``report.closure_residual`` tells how far they are from it."""
        return spin_result(*self._kernel.integrate(real(spins, self._function, "spins")))

    def derivative(self, rho: Values, *, on: Optional[str] = None,
                   tolerance: float = 1e-12) -> Spin_derivative:
        """The derivative at rho of the transformation without a bound, see ``Spin_derivative``."""
        return Spin_derivative(self._kernel.positions(), self._faces, rho, on=on,
                               tolerance=tolerance, boundary=self._boundary,
                               mollification=self._mollification)


def spin_transform(V: Points, F: Faces, rho: Values, *, on: Optional[str] = None,
                   max_scale: Optional[float] = default_max_scale, vertex_scale: Optional[Vertex_values] = None,
                   vertex_scale_weight: Optional[Vertex_values] = None,
                   boundary: Optional[Boundary_condition] = None,
                   exactness: Optional[str] = "adjoint",
                   max_period_defect: Optional[float] = None,
                   mollification: Optional[float] = None, exact_conformal_class: bool = False,
                   tolerance: float = 1e-8, max_iterations: int = 200, random_seed: int = 0,
                   dirac: Dirac_options = Dirac_options(),
                   limits: Optional[Dict[str, float]] = None,
                   callback: Callback = None) -> Spin_result:
    """Deforms a surface conformally so that its mean curvature changes as prescribed
    [CGP (5.3)-(5.5)].

    Solves (D - rho) lambda = gamma lambda and integrates the edges conjugate(lambda) df lambda.
    Then H~ |lambda|^2 = H + rho + gamma: positive rho bulges along the normals, and constants have
    no effect. Angles are kept up to the error of the discretisation; area and centroid are kept.
    On limbs, rho alone may scale lengths by large factors: by default the nearest rho is applied
    that scales them by no more than 2.

    Parameters
    ----------
    V : (n, 3) array of real numbers
        the vertices of a connected, oriented manifold, with normals outward
    F : (m, 3) array of integers
        the vertices of the triangles, counter-clockwise, from 0
    rho : (n,) or (m,) array
        the change of mean curvature in 1/length of the mesh, per vertex or per face
    on : "vertices" or "faces", optional
        what rho belongs to, where its length does not tell
    max_scale : float > 1, or None
        b: lengths are multiplied by factors in [1/b, b] on 98 % of the area, at tips 1.5
        times that; where rho would do more, the nearest rho that does not is applied
        (``report.scales`` tells what was kept), and less of it where the map would be beyond
        ``limits``. 1.5 to 3 keep limbs recognisable. The
        default is 2, 1.25 with vertex_scale, and no bound where the boundary has prescribed
        positions or directions. None: no bound, rho is applied as it is, and lambda is the
        eigenvector of the thesis
    vertex_scale, vertex_scale_weight : (n,) arrays, optional
        wanted factors of lengths, to which the bound is relative, and how much the size matters
        there; 0 where lengths may change freely
    boundary : Boundary_condition, optional
        by default a boundary is free
    exactness : "adjoint", "thesis" or None
        how handles and holes are kept closed: part of rho is left out, and a strong one applied in
        steps [CGP 6.4.5]. None: not at all, which shears them
    max_period_defect : float, optional
        the largest part of the edges that may fail to close up; by default a quarter of the
        discretisation error
    mollification : float in (0, 1), optional
        admits faces of any thinness, also of area zero; 1e-6 is a good value
    exact_conformal_class : bool
        whether the result is moved to the surface with exactly the length cross-ratios of the mesh
        (``report.exact_class``)
    tolerance : float
        upper bound of the error estimate of lambda; this and the next options are for the
        eigenvector, which there is only without a bound on lengths
    max_iterations : int
        of the eigensolver
    random_seed : int
        of start vectors; same input, same bits
    dirac : Dirac_options
        what is seldom set
    limits : dict, optional
        other bounds of what counts as success, by the names of ``Limits``
    callback : function of Progress, optional
        called after every iteration; returns False to cancel. What it raises ends the computation,
        as Ctrl-C does with or without a callback.

    Returns
    -------
    Spin_result
        true if the surface is what was asked for

    Raises
    ------
    Precondition_error
        if the mesh, rho, or an option is unsuitable; it names the first offending element
    Solver_error
        if a factorization fails
    """
    transformation = Spin_transformation(
        V, F, boundary=boundary, max_scale=max_scale, vertex_scale=vertex_scale,
        vertex_scale_weight=vertex_scale_weight, exactness=exactness,
        max_period_defect=max_period_defect, mollification=mollification,
        exact_conformal_class=exact_conformal_class, function="spin_transform")
    return transformation.transform(
        rho, on=on, tolerance=tolerance, max_iterations=max_iterations, random_seed=random_seed,
        dirac=dirac, limits=limits, callback=callback)


def minimal_surface(V: Points, F: Faces, *, boundary: Optional[Boundary_condition] = None,
                    tolerance: float = 1e-8, max_iterations: int = 200, random_seed: int = 0,
                    dirac: Dirac_options = Dirac_options(),
                    callback: Callback = None) -> Spin_result:
    """The minimal surface conformally equivalent to a surface with boundary, by rho = -H in one
    solve [CGP 6.5.3]. By default it keeps the tangents of the boundary; with binormals, the report
    is false where no eigenvalue is 0. A kernel_tolerance of 0 is 3 h / R^2. The parameters are
    those of ``spin_transform()``."""
    name = "minimal_surface"
    options = dict(vars(dirac), tolerance=tolerance, max_iterations=max_iterations,
                   random_seed=random_seed)
    return spin_result(*_kernels.minimal_surface(points(V, name), faces(F, name), boundary, options,
                                                 _progress(callback)))
