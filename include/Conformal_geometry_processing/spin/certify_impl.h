// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CERTIFY_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CERTIFY_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/spin/certify.h>
#include <Conformal_geometry_processing/spin/rotated_normals.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE void certify(const Mesh_view& measured, const Points& f,
                        const Quaternion_vector<double>& lambda, Spin_report& report)
{
  report.conformality = conformality(measured, f, rotated_normals(measured, lambda));
  const auto size = components(lambda).colwise().norm();
  report.min_spin_ratio = size.minCoeff() / size.maxCoeff();
  report.converged = report.converged && f.allFinite();
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
