# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Conformal geometry processing on NumPy arrays, after K. Crane, *Conformal Geometry Processing*
(PhD thesis, Caltech, 2013; [CGP] below).

A mesh is two arrays: V, n x 3, the points of its vertices, and F, m x 3, the vertices of its
triangles, counter-clockwise seen from outside. Nothing is changed in place; same input, same bits.

>>> import conformal_geometry as cg
>>> result = cg.spin_transform(V, F, rho)  # rho: the change of mean curvature, in 1/length
>>> result or print(result.report.fault)
>>> result.positions
"""

from ._boundary import Boundary_condition
from ._deform import Conformal_deformation, Deformation_result, deform
from ._derivative import Spin_derivative
from ._errors import Error, Precondition_error, Solver_error
from ._fit import Nearest_result, blend, nearest
from ._flow import Flow_result, willmore_flow
from ._kernels import __version__, default_max_scale
from ._matrices import (cotan_laplacian, dirac_energy, dirac_operator, face_areas, mean_curvature,
                        quasi_conformal_errors, vertex_areas)
from ._reports import (Area_distortion, Class_snap_report, Conformality, Distribution, Enclosure, Flow_report,
                       Flow_step_report, Length_cross_ratio_change, Limits, Mean_and_max,
                       Mollification, Overlap_summary, Parameterization_report, Place, Realised_curvature,
                       Scales, Spin_report)
from ._spin import (Dirac_options, Progress, Spin_result, Spin_transformation, minimal_surface,
                    spin_transform)
from ._surfaces import (Class_snap_result, Delaunay_faces, Dirac_spectrum, Flattening, Harmonic_basis,
                        dirac_spectrum, flatten, harmonic_basis, make_delaunay, snap_to_conformal_class)
from ._view import View, view

__all__ = [
    "spin_transform", "Spin_transformation", "Dirac_options", "Spin_derivative", "Boundary_condition",
    "deform", "Conformal_deformation", "willmore_flow", "flatten", "nearest", "blend",
    "minimal_surface", "harmonic_basis", "view", "View",
    "dirac_spectrum", "snap_to_conformal_class", "make_delaunay", "dirac_operator", "dirac_energy",
    "cotan_laplacian", "vertex_areas", "face_areas", "mean_curvature", "quasi_conformal_errors",
    "Spin_result", "Deformation_result", "Nearest_result", "Flow_result", "Flattening", "Harmonic_basis",
    "Dirac_spectrum", "Class_snap_result", "Delaunay_faces", "Progress", "Spin_report", "Flow_report",
    "Flow_step_report", "Parameterization_report", "Class_snap_report", "Conformality",
    "Distribution", "Enclosure", "Length_cross_ratio_change", "Area_distortion", "Mollification",
    "Scales", "Realised_curvature", "Overlap_summary", "Mean_and_max", "Limits", "Place",
    "default_max_scale",
    "Error", "Precondition_error", "Solver_error", "__version__",
]
