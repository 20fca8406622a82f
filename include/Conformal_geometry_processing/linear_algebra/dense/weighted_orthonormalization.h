// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_WEIGHTED_ORTHONORMALIZATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_WEIGHTED_ORTHONORMALIZATION_H

#include <Eigen/Core>

namespace Conformal_geometry_processing {
/// \ingroup PkgLinearAlgebra
/// \brief an orthonormal basis of the span of some functions, in the inner product
/// sum_i w_i a_i b_i, without the directions in which they hardly extend.
///
/// Directions whose singular value is below `threshold` times the largest are dropped: functions
/// that depend on each other up to rounding or discretisation errors differ by nothing but noise,
/// which a plain Gram-Schmidt process would normalise. Functions should be scaled alike; none at
/// all, and functions that vanish, have the empty basis.
///
/// From the eigenvectors of the Gram matrix, and then by Gram and Schmidt's process, which makes
/// the basis orthonormal to rounding. Deterministic. About 8 n k^2 operations, and the memory of
/// the functions once more.
///
/// \param functions n x k, one per column
/// \param weights n positive numbers
/// \param threshold at least 1e-7: the Gram matrix knows no smaller singular values
/// \returns n x r, r <= k, in the order of decreasing singular values
/// \throw Precondition_error if the sizes differ, a weight is not positive or a value not finite
Eigen::MatrixXd weighted_orthonormalization(const Eigen::MatrixXd& functions,
                                            const Eigen::VectorXd& weights,
                                            double threshold = 1e-3);

/// \ingroup PkgLinearAlgebra
/// \brief the singular values of some functions in the inner product sum_i w_i a_i b_i, decreasing;
/// those below 1e-7 of the largest are rounding errors. 2 n k^2 operations.
/// \throw Precondition_error as `weighted_orthonormalization()`
Eigen::VectorXd weighted_singular_values(const Eigen::MatrixXd& functions,
                                         const Eigen::VectorXd& weights);

/// \ingroup PkgLinearAlgebra
/// \brief v without its part in the span of a basis that is orthonormal with the weights.
///
/// Projects twice, so that a v almost inside the span is left with rounding errors of its own size
/// that are orthogonal all the same. 8 n k operations.
/// \pre `basis` is what `weighted_orthonormalization()` returned for these weights
Eigen::VectorXd project_out(const Eigen::MatrixXd& basis, const Eigen::VectorXd& weights,
                            Eigen::VectorXd v);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/dense/weighted_orthonormalization_impl.h>
#endif

#endif
