# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Conformal deformations that move control points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Dict, Mapping, Optional

import numpy as np

from . import _kernels
from ._arrays import faces, points, real, real_or_none
from ._kernels import default_max_scale
from ._report import build
from ._reports import Spin_report, known
from ._spin import Callback, Spin_result, _progress, scale_bound
from ._types import Faces, Points, Value_array, Vector, Vertex_values


@dataclass(frozen=True, eq=False)
class Deformation_result(Spin_result):
    """A surface whose control points have moved. ``report.reached`` is the share of the way to the
    targets, ``report.position_error`` the distances that remain."""
    rho: Value_array  #: the change of mean curvature that was found, one per vertex, in 1/length


class Conformal_deformation:
    """Many deformations of one mesh, as while a control point is dragged.

    The parameters are those of ``deform()``; the mesh is copied. An object is used by one thread
    at a time; different objects compute at the same time.
    """

    def __init__(self, V: Points, F: Faces, *, position_weight: Optional[float] = None,
                 max_scale: Optional[float] = default_max_scale, vertex_scale: Optional[Vertex_values] = None,
                 vertex_scale_weight: Optional[Vertex_values] = None, vertex_region: Optional[Vertex_values] = None,
                 exactness: Optional[str] = "adjoint", mollification: Optional[float] = None,
                 function: str = "Conformal_deformation") -> None:
        self._function = function
        options = dict(
            position_weight=position_weight, exactness=exactness, **scale_bound(max_scale),
            vertex_scale=real_or_none(vertex_scale, function, "vertex_scale"),
            vertex_scale_weight=real_or_none(vertex_scale_weight, function, "vertex_scale_weight"),
            vertex_region=real_or_none(vertex_region, function, "vertex_region"),
            mollification=mollification)
        self._kernel = _kernels.Deformation(points(V, function), faces(F, function), options,
                                            function)

    def deform(self, targets: Mapping[int, Vector], *, limits: Optional[Dict[str, float]] = None,
               callback: Callback = None) -> Deformation_result:
        """The initial surface with vertices at the targets. With the vertices of the last call,
        the search starts from its result: a small move takes a few factorizations."""
        places = points([real(to, self._function, "targets") for to in targets.values()],
                        self._function)
        positions, spins, report, rho = self._kernel.deform(
            [int(v) for v in targets], places, known(limits), _progress(callback))
        return Deformation_result(positions, spins, build(Spin_report, report), rho)


def deform(V: Points, F: Faces, targets: Mapping[int, Vector], *, position_weight: Optional[float] = None,
           max_scale: Optional[float] = default_max_scale, vertex_scale: Optional[Vertex_values] = None,
           vertex_scale_weight: Optional[Vertex_values] = None, vertex_region: Optional[Vertex_values] = None,
           exactness: Optional[str] = "adjoint", mollification: Optional[float] = None,
           limits: Optional[Dict[str, float]] = None,
           callback: Callback = None) -> Deformation_result:
    """Deforms a surface conformally so that vertices move to given places, exactly: by the least
    smooth change rho of mean curvature and spins that nearly solve its Dirac equation [CGP
    (5.3)-(5.5)], whose surface, placed by a similarity, has them there.

    What similarities can do costs nothing: one or two targets move, turn and scale the whole. Hold
    parts by targets where they are. Targets beyond reach are approached as far as the surface
    verifies without flips: ``report.reached`` is the share of the way, and the result is false
    below 1.

    Parameters
    ----------
    V : (n, 3) array
        the points of the mesh
    F : (m, 3) array of integers
        its triangles, counter-clockwise seen from outside
    targets : dict
        new positions by the numbers of vertices, in the unit of V
    position_weight : float, optional
        weight of the distances from the targets against rho, in multiples of 1/R with R the radius
        of the sphere of the same area; None: the targets are met exactly
    vertex_region : (n,) array, optional
        the region that may move: 1 where it follows the targets, 0 where it stays as it is, to the
        bit, between them it fades out; ``report.collar`` tells how conformal it is there
    limits : dict, optional
        what counts as success, see ``Limits``; ``realised_share`` is 1 unless it is given
    other parameters
        as in ``spin_transform()``; bounds on scales are relative to the similarity
    """
    return Conformal_deformation(
        V, F, position_weight=position_weight, max_scale=max_scale, vertex_scale=vertex_scale,
        vertex_scale_weight=vertex_scale_weight, vertex_region=vertex_region, exactness=exactness,
        mollification=mollification, function="deform").deform(
            targets, limits=limits, callback=callback)
