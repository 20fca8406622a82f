// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CLOSURE_RESIDUAL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CLOSURE_RESIDUAL_H

#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief |d0 f - e| / |e|: how far the edges of positions f are from given edge vectors e.
///
/// The norms use |w|, because w is negative opposite large angles and then defines no norm.
/// \param weights w, `cotan_weights()` of the surface, |E|
/// \param f 3 x |V| \param edges |E| x 3, not all zero
double closure_residual(const Surface_ref& surface, const Eigen::VectorXd& weights, const Points& f,
                        const Eigen::MatrixX3d& edges);

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/closure_residual_impl.h>
#endif

#endif
