// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// M_F: the area of each face of the mesh, |F| numbers; the diagonal of a positive semidefinite
/// matrix, definite where no face has area zero [CGP 5.4]
Eigen::VectorXd face_areas(const Surface_ref& surface);

/// \ingroup PkgOperators
/// M_V: the barycentric area of each vertex, a third of the area of the faces around it, |V|
/// numbers; the diagonal of a positive definite matrix [CGP 5.4]
/// \pre every vertex has a triangle of positive area
Eigen::VectorXd vertex_areas(const Surface_ref& surface);

/// \ingroup PkgOperators
/// the mixed Voronoi area of each vertex: the part of each non-obtuse face that is nearest to the
/// vertex; half of an obtuse face at its obtuse corner, a quarter at each other.
///
/// Pointwise curvatures require these (`mean_curvature()`): with barycentric areas, H has an error
/// of 15 % at vertices of valence 5 even on fine meshes.
Eigen::VectorXd voronoi_areas(const Surface_ref& surface);

}  // namespace Conformal_geometry_processing
