// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief N = -1/2 D f, 3 x |F|: exactly the face normals.
Points dirac_normals(const internal::Surface_derivative& d);

/// \ingroup PkgOperators
/// \brief the mean curvature H = 1/2 N D N = -1/2 <N, D N> on the faces, |F|; +1 on the unit
/// sphere.
///
/// First order, and damps high frequencies as D does. At vertices and for flows, use
/// `mean_curvature()`.
/// \param normals of the surface at its vertices, 3 x |V|
Eigen::VectorXd dirac_mean_curvature(const internal::Surface_derivative& d, const Points& normals);

/// \ingroup PkgOperators
/// \brief the Gauss curvature K = 1/2 <N, Im(D^2) N> at the vertices, |V|, from the imaginary part
/// of D^H M_F D, whose rows sum to zero and which contains only the jumps of the face normals.
///
/// The integral of K is exact for the matrix: second order on regular meshes.
/// \param normals of the surface at its vertices, 3 x |V|
/// \pre the surface is closed
Eigen::VectorXd dirac_gauss_curvature(const internal::Surface_derivative& d, const Points& normals);

}  // namespace Conformal_geometry_processing
