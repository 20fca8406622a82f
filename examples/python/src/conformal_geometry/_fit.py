# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Conformal deformations near given ones, and between two."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Optional

import numpy as np

from . import _kernels
from ._arrays import faces, points, real, real_or_none
from ._report import build
from ._reports import Spin_report, known
from ._spin import Callback, Dirac_options, Spin_result, _progress, spin_result
from ._types import Faces, Points, Vector, Vertex_values


@dataclass(frozen=True, eq=False)
class Nearest_result(Spin_result):
    """A conformal deformation near a given one."""
    distance: float  #: root mean square from the target, relative to the diagonal of its box, by area
    normal_distance: float  #: likewise of the unit normals of the faces; wrinkles raise it
    sign_conflicts: int  #: of the spins of the target; 0 for smooth deformations


def nearest(V: Points, target: Points, F: Faces, *, blend: float = 0., keep_curvature: bool = False,
            normal_weight: float = 1., shear: Optional[float] = None,
            distance_tolerance: float = 1e-4, direction: Vector = (1, 0, 0),
            max_scale: Optional[float] = None, vertex_scale: Optional[Vertex_values] = None,
            exactness: Optional[str] = "adjoint", max_period_defect: Optional[float] = None,
            mollification: Optional[float] = None, tolerance: float = 1e-8,
            max_iterations: int = 200, random_seed: int = 0,
            dirac: Dirac_options = Dirac_options(), limits: Optional[Dict[str, float]] = None,
            callback: Callback = None) -> Nearest_result:
    """Deforms a surface conformally, as closely as possible to a given deformation: minimises the
    mean square distance of the vertices after the best similarity, as far as the normals come
    nearer with it. The result is never farther from the target than the surface. So any editor
    becomes a conformal one.

    Parameters
    ----------
    V, target : (n, 3) arrays
        the surface, and its vertices after the deformation
    F : (m, 3) array of integers
    blend : float
        t: the surface of (1 - t) lambda + t mu, with the spins mu of the target; conformal for 0
    keep_curvature : bool
        the surface with the curvature of the target and, at a boundary, its tangents, wherever
        that is [CGP 5.9, 6.3]
    normal_weight : float
        how much the normals count beside the positions; with 0, positions come nearer by
        wrinkles, where the target is far from conformal
    shear : float > 0, optional
        how far from conformal the result may be: the largest closure residual; by default about .05
    distance_tolerance : float
        the search ends at this distance, relative to the diagonal, and a hundred times as many
        radians between normals: a tenth of a pixel of a picture of 1,000 pixels
    direction : (t, n, b)
        what of the boundary frame is taken from the target; (0, 0, 1), the binormals, can be
        realised for any
    max_scale : float > 1, optional
        b: lengths are multiplied by factors in [1/b, b] on 98 % of the area, at tips 1.5
        times that; by default there is no bound, for the lengths are those of the target
    vertex_scale : (n,) array, optional
        factors of lengths that are to come on top; keeps the curvature
    other parameters
        as in ``spin_transform()``
    """
    name = "nearest"
    options = dict(vars(dirac), direction=real(direction, name, "directions"), keep_curvature=keep_curvature,
                   normal_weight=float(normal_weight), shear=shear,
                   distance_tolerance=float(distance_tolerance), max_scale=max_scale,
                   vertex_scale=real_or_none(vertex_scale, name, "factors"), exactness=exactness,
                   max_period_defect=max_period_defect, mollification=mollification,
                   tolerance=tolerance, max_iterations=max_iterations, random_seed=random_seed)
    positions, spins, report, distance, normal_distance, conflicts = _kernels.nearest(
        points(V, name), points(target, name), faces(F, name), float(blend), options, known(limits),
        _progress(callback))
    return Nearest_result(positions, spins, build(Spin_report, report), distance, normal_distance,
                          conflicts)


def blend(A: Points, B: Points, F: Faces, t: float = 0.5, *, onto: Optional[Points] = None,
          keep_curvature: bool = False, distance_tolerance: float = 1e-4,
          tolerance: float = 1e-8, random_seed: int = 0, callback: Callback = None) -> Spin_result:
    """Goes from one surface towards a conformally equivalent one, or beyond: adds t times the
    difference of their mean curvature half-densities [CGP 4.4], corrected so that t = 1 is B to the
    eye, or the conformal surface nearest to it.

    Every surface on the way is conformally equivalent to both. Area and centroid are those of the
    start; at a boundary the binormals turn evenly.

    Parameters
    ----------
    A, B : (n, 3) arrays
        two surfaces; t = 0 gives A, 1 gives B up to a similarity, 1.5 exaggerates
    F : (m, 3) array of integers
    onto : (n, 3) array, optional
        a third surface of the conformal class, to which the difference is added in place of A
    keep_curvature : bool
        adds the plain difference, which leads to B up to O(h^2), without a search
    distance_tolerance : float
        of the search, as in ``nearest()``
    tolerance, random_seed, callback
        as in ``spin_transform()``
    """
    name = "blend"
    start = A if onto is None else onto
    return spin_result(*_kernels.blend(
        points(A, name), points(B, name), points(start, name), faces(F, name), float(t),
        dict(keep_curvature=keep_curvature, distance_tolerance=float(distance_tolerance),
             tolerance=tolerance, random_seed=random_seed),
        _progress(callback)))
