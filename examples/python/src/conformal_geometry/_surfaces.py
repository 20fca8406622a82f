# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Maps to the plane, harmonic forms, spectra, the exact conformal class, and Delaunay faces."""

from __future__ import annotations

from dataclasses import dataclass
from operator import index
from typing import List, Optional

import numpy as np

from . import _kernels
from ._arrays import faces, points, real_or_none
from ._boundary import Boundary_condition
from ._report import Result, build
from ._reports import Class_snap_report, Parameterization_report
from ._types import (Edge_array, Face_array, Faces, Field_array, Form_array, Number_array, Plane_array,
                     Point_array, Points, Spinor_array, Value_array, Values)


@dataclass(frozen=True, eq=False)
class Flattening(Result):
    """A map to the plane."""
    uv: Plane_array  #: n x 2, in the unit of the mesh
    report: Parameterization_report


def flatten(V: Points, F: Faces, *, normals: str = "faces", boundary: str = "longest_loop",
            tolerance: float = 1e-6, max_iterations: int = 100) -> Flattening:
    """Flattens a surface with boundary with least distortion of angles [CGP 6.1]: the spectral
    conformal parameterization of Mullen et al. No vertex is pinned; the surface may have holes. The
    image has the area of the surface, and its longest loop is centred at the origin.

    Parameters
    ----------
    V : (n, 3) array, F : (m, 3) array of integers
    normals : "faces" or "vertices"
        the conformal energy itself, or the variant of the thesis, which is worse on scans
    boundary : "longest_loop" or "all_loops"
        whose variance is fixed
    tolerance, max_iterations
        relative error of the map in the norm of the energy, and the bound of the work
    """
    name = "flatten"
    uv, report = _kernels.flatten(
        points(V, name), faces(F, name), dict(normals=normals, boundary=boundary,
                                              tolerance=tolerance, max_iterations=max_iterations))
    return Flattening(uv, build(Parameterization_report, report))


@dataclass(frozen=True, eq=False)
class Harmonic_basis:
    """The harmonic 1-forms of a surface, orthonormal, with their tangent fields."""
    edges: Edge_array  #: |E| x 2: the vertices i < j of each edge
    one_forms: Form_array  #: |E| x k, along i -> j; dimensionless
    fields: Field_array  #: k x m x 3, one vector for each face, in 1/length

    def __len__(self) -> int:
        return self.one_forms.shape[1]


def harmonic_basis(V: Points, F: Faces) -> Harmonic_basis:
    """The harmonic 1-forms of a surface: 2G for genus G, and 2G + L - 1 with L boundary loops; none
    for spheres and disks [CGP 6.4.5.1]. Closed and co-closed, tangent to a boundary. The basis
    depends on the order of the vertices and faces. One factorization, and two solves per form."""
    name = "harmonic_basis"
    F = faces(F, name)
    edges, forms, fields = _kernels.harmonic_basis(points(V, name), F)
    return Harmonic_basis(edges, forms, np.array(fields).reshape(-1, len(F), 3))


@dataclass(frozen=True, eq=False)
class Dirac_spectrum:
    """Eigenvalues of D - rho, those nearest to the shift first. True if these are the wanted ones:
    all within ``complete_radius`` of the shift."""
    shift: float
    wanted: int
    eigenvalues: Value_array  #: k, signed, in 1/length
    pencil_eigenvalues: Value_array  #: k, those of [CGP (5.2)]
    residuals: Value_array  #: k, relative
    vectors: Spinor_array  #: k x n x 4: spins, of mean square 1
    size_of_constants: int
    complete_radius: float
    restarts: int
    converged: bool
    cancelled: bool
    is_complete: bool

    def __bool__(self) -> bool:
        return self.is_complete


def dirac_spectrum(V: Points, F: Faces, count: int, *, rho: Optional[Values] = None, on: Optional[str] = None,
                   shift: float = 0., boundary: Optional[Boundary_condition] = None,
                   tolerance: float = 1e-8, max_restarts: int = 100, random_seed: int = 0
                   ) -> Dirac_spectrum:
    """Eigenvalues of D - rho nearest to a shift, with their eigenfunctions [CGP 5.8.2]. On the unit
    sphere they are all integers n but -1, with multiplicity |n + 1|; each eigenfunction is the spin
    of a Dirac surface. At a boundary, binormals are kept, or the directions of ``boundary``, which
    have to be orthogonal to the tangents. One factorization; errors of O(h^2)."""
    name = "dirac_spectrum"
    found = _kernels.dirac_spectrum(
        points(V, name), faces(F, name), index(count), real_or_none(rho, name, "values of rho"), on or "",
        dict(shift=shift, boundary=boundary, tolerance=tolerance, max_restarts=max_restarts,
             random_seed=random_seed))
    vectors: List[np.ndarray] = found.pop("vectors")
    return Dirac_spectrum(vectors=np.array(vectors).reshape(len(vectors), -1, 4), **found)


@dataclass(frozen=True, eq=False)
class Class_snap_result(Result):
    """A surface on the exact discrete conformal class of another."""
    positions: Point_array  #: n x 3
    report: Class_snap_report


def snap_to_conformal_class(V: Points, reference: Points, F: Faces, *, on_delaunay: bool = False,
                            tolerance: float = 1e-10, max_iterations: int = 40
                            ) -> Class_snap_result:
    """Moves a surface, by as little as possible, to one with exactly the length cross-ratios of a
    reference [Springborn, Schroeder and Pinkall 2008]; for surfaces that are nearly conformally
    equivalent, as after a spin transformation. Any genus, any number of components.

    Parameters
    ----------
    V, reference : (n, 3) arrays
        the surface, and that whose conformal class is wanted
    F : (m, 3) array of integers
    on_delaunay : bool
        the class of the intrinsic Delaunay triangulation of the reference; slivers have no part
    tolerance, max_iterations
        of the logarithms of length cross-ratios, and the bound of the work
    """
    name = "snap_to_conformal_class"
    positions, report = _kernels.snap_to_conformal_class(
        points(V, name), points(reference, name), faces(F, name), on_delaunay, tolerance,
        max_iterations)
    return Class_snap_result(positions, build(Class_snap_report, report))


@dataclass(frozen=True, eq=False)
class Delaunay_faces:
    """The faces of a mesh after flips of its edges."""
    faces: Face_array  #: m x 3: the vertices of each face
    changed: Number_array  #: the faces that have other vertices than before, ascending
    flips: int


def make_delaunay(V: Points, F: Faces) -> Delaunay_faces:
    """Flips edges until no two angles opposite to one have a sum above pi, but where a flip would
    join two vertices twice or leave a face without area. V and the boundary stay.

    ``willmore_flow()`` computes on such faces, and stops where it leaves the limits on F, which may
    be slivers: with the flipped faces the two are the same."""
    name = "make_delaunay"
    F = faces(F, name)
    flipped, flips = _kernels.make_delaunay(points(V, name), F)
    changed = np.flatnonzero((np.sort(flipped, axis=1) != np.sort(F, axis=1)).any(axis=1))
    return Delaunay_faces(flipped, changed, flips)
