# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What the boundary of a surface does in a spin transformation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ._arrays import real, real_or_none
from ._types import Points, Vector


@dataclass(frozen=True, eq=False)
class Boundary_condition:
    """The boundary condition of a spin transformation [CGP 4.5.4]; make it by one of the functions
    below.

    Arrays have one row for *every* vertex of the mesh, as V has; only those of the boundary are
    read. Vectors may have any length but zero. Data that no conformal surface has are not an error: the
    report is then false, and names its ``boundary_fault``.
    """

    kind: str = "free"
    direction: Optional[np.ndarray] = None
    targets: Optional[np.ndarray] = None
    normals: Optional[np.ndarray] = None
    weight: float = float("inf")

    @staticmethod
    def free() -> "Boundary_condition":
        """No condition: of all surfaces with the curvature, the nearest is taken."""
        return Boundary_condition()

    @staticmethod
    def tangents(targets: Optional[Points] = None) -> "Boundary_condition":
        """The tangents become those given, n x 3; without any, they are kept."""
        return Boundary_condition.directions((1, 0, 0), targets)

    @staticmethod
    def binormals(targets: Optional[Points] = None) -> "Boundary_condition":
        """The binormals (tangent to the surface, across the boundary) become those given, n x 3;
        without any, they are kept. Any binormals can be realised."""
        return Boundary_condition.directions((0, 0, 1), targets)

    @staticmethod
    def directions(direction: Vector, targets: Optional[Points] = None) -> "Boundary_condition":
        """The direction t T + n N + b B of the boundary frame, by its coefficients (t, n, b),
        becomes that given, n x 3; without any, it is kept. Not the normal alone."""
        name = "Boundary_condition"
        return Boundary_condition("directions", real(direction, name, "directions"),
                                  real_or_none(targets, name, "directions"))

    @staticmethod
    def positions(targets: Points, normals: Optional[Points] = None, weight: float = float("inf")
                  ) -> "Boundary_condition":
        """The boundary moves to positions, n x 3, with given normals of the new surface, n x 3 (by
        default those of the mesh with all of its vertices at ``targets``). No conformal surface
        need have it: distortion is minimised. A finite ``weight`` attaches the boundary in a
        layer of the width radius / weight [CGP 6.3.2]."""
        name = "Boundary_condition"
        return Boundary_condition("positions", None, real(targets, name, "positions"),
                                  real_or_none(normals, name, "normals"), weight)
