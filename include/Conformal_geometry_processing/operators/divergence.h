// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIVERGENCE_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIVERGENCE_H

#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief d0 u, |E| x k, of k functions given as columns: u_j - u_i along each edge i -> j.
/// \param u |V| x k
inline Eigen::MatrixXd differential(const Surface_ref& surface, const Eigen::MatrixXd& u)
{
  Eigen::MatrixXd du(surface.size_of_edges(), u.cols());
  for (int k = 0; k < surface.size_of_edges(); ++k)
    du.row(k) = u.row(surface.ends(k)[1]) - u.row(surface.ends(k)[0]);
  return du;
}

/// \ingroup PkgOperators
/// \brief d0^T diag(w) omega, |V| x k, of k 1-forms given as one row of `omega` per edge i -> j.
///
/// Row i is the sum of w_ij omega over the edges *into* i minus the edges out of it. [CGP 5.6]
/// calls this the divergence; it is *minus* the usual one, to match the positive semidefinite L:
/// codifferential(d0 f) = L f. Columns sum to zero.
/// \param w `cotan_weights(surface)`, |E| \param omega |E| x k
template <class Derived>
Eigen::Matrix<double, Eigen::Dynamic, Derived::ColsAtCompileTime> codifferential(
    const Surface_ref& surface, const Eigen::VectorXd& w, const Eigen::MatrixBase<Derived>& omega)
{
  Eigen::Matrix<double, Eigen::Dynamic, Derived::ColsAtCompileTime> sum(surface.size_of_vertices(),
                                                                        omega.cols());
  sum.setZero();
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    sum.row(surface.ends(k)[0]) -= w[k] * omega.row(k);
    sum.row(surface.ends(k)[1]) += w[k] * omega.row(k);
  }
  return sum;
}

}  // namespace Conformal_geometry_processing

#endif
