// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace Conformal_geometry_processing {
/// \ingroup PkgLinearAlgebra
/// \brief Computes an orthonormal basis of the span of some functions, in the inner product
/// sum_i w_i a_i b_i, and omits nearly dependent directions.
///
/// Directions whose singular value is below `threshold` times the largest one are dropped: if
/// functions are dependent up to rounding or discretization errors, their differences are noise,
/// which a plain Gram-Schmidt process would normalize. The functions should have similar norms. The
/// basis is empty if there are no functions or all of them vanish.
///
/// Uses the eigenvectors of the Gram matrix, followed by a Cholesky decomposition that makes the
/// basis orthonormal up to rounding. Deterministic. About 8 n k^2 operations, in the memory of the
/// functions where they are moved into the call.
///
/// \param functions n x k, one per column
/// \param weights n positive numbers
/// \param threshold at least 1e-7: smaller singular values are lost in the Gram matrix
/// \returns n x r, r <= k, in the order of decreasing singular values
/// \throw Precondition_error if the sizes differ, a weight is not positive or a value not finite
Eigen::MatrixXd weighted_orthonormalization(Eigen::MatrixXd functions,
                                            const Eigen::VectorXd& weights,
                                            double threshold = 1e-3);

/// \ingroup PkgLinearAlgebra
/// \brief Returns the component of v orthogonal to the span of a basis that is orthonormal with
/// respect to the weights.
///
/// Projects twice, so that the result is orthogonal even if v is almost inside the span and the
/// result consists of rounding errors. 8 n k operations.
/// \pre `basis` was returned by `weighted_orthonormalization()` for these weights
Eigen::VectorXd project_out(const Eigen::MatrixXd& basis, const Eigen::VectorXd& weights,
                            Eigen::VectorXd v);

}  // namespace Conformal_geometry_processing
