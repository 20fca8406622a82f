// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the expected normals of the faces after a spin transformation: rotated by the mean spin
/// of their corners, 3 x |F|, not normalised.
Points rotated_normals(const Mesh_view& mesh, const Quaternion_vector<double>& lambda);

namespace internal {

/// \brief Writes into the report how conformal the map from a surface to new positions is, and the
/// ratio of the smallest to the largest spin; if a position is not finite, the result has not
/// converged.
/// \param measured the surface, or its part with positive areas
/// \param f 3 x |V| \param lambda |V|
void certify(const Mesh_view& measured, const Points& f, const Quaternion_vector<double>& lambda,
             Spin_report& report);

}  // namespace internal

}  // namespace Conformal_geometry_processing
