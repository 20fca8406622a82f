// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief fixes the gauge of an eigenvector lambda, a right factor: makes its mean real and
/// positive and the mean of |lambda|^2 one.
///
/// A constant lambda thus becomes 1, and the surface as a whole neither turns nor grows. If the
/// mean vanishes (it has no direction), the largest value is made real instead.
/// \param areas the weights of the mean, |V| positive numbers
void fix_gauge(Quaternion_vector<double>& lambda, const Eigen::VectorXd& areas,
               const internal::Surface_part& part = {});

/// \ingroup PkgSpin
/// \brief scales new positions f, and the spins that led to them, so that the area is that of the
/// mesh, and moves the centroid to that of the mesh.
void restore_area(const Mesh_view& mesh, Points& f, Quaternion_vector<double>& lambda,
                  const internal::Surface_part& part = {});

}  // namespace Conformal_geometry_processing
