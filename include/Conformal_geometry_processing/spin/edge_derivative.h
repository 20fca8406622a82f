// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the change of `transformed_edges()` with lambda, |E| x 3: they are quadratic in it.
Eigen::MatrixX3d edge_change(const Surface_ref& surface, const Quaternion_vector<double>& lambda,
                             const Quaternion_vector<double>& dlambda);

/// \ingroup PkgSpin
/// \brief the transpose: the gradient q of the sum of <y_k, e~_k> over the edges, |V|: its change
/// is Re <q, dlambda>. \param y |E| x 3
Quaternion_vector<double> edge_gradient(const Surface_ref& surface,
                                        const Quaternion_vector<double>& lambda,
                                        const Eigen::MatrixX3d& y);

}  // namespace Conformal_geometry_processing::internal
