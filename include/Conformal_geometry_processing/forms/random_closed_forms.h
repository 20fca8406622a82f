// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_RANDOM_CLOSED_FORMS_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_RANDOM_CLOSED_FORMS_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/exterior_derivative.h>

#include <cassert>
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// \brief random 1-forms without their co-exact parts: the generators that the thesis starts from
/// [CGP 6.4.5.1], in place of `closed_generators()`.
///
/// Takes gamma = alpha - w^-1 d1^T b with d1 w^-1 d1^T b = d1 alpha for numbers alpha in [-1, 1).
/// Divides by the cotan weights w, which are zero opposite right angles; otherwise the matrix is
/// regular up to the constants, though indefinite if weights are negative. A matrix on the faces
/// is factored with pivoting: much slower than trees.
///
/// \returns |E| x 2G, or 2G + loops - 1 with a boundary; almost surely no combination is exact
/// \param function named in the exception
/// \pre `require_surface(mesh)` holds
/// \throw Precondition_error if a weight is zero; the message names the first such edge
inline Eigen::MatrixXd random_closed_forms(const Mesh_view& mesh, unsigned seed,
                                           const std::string& function = "random_closed_forms")
{
  const double least_weight = 1e-12;
  const Eigen::VectorXd w = cotan_weights(mesh);
  internal::refuse_if_any(
      mesh.size_of_edges(), [&](int k) { return !(std::abs(w[k]) > least_weight); },
      [&](int k) { return internal::name_of_edge(mesh, k); }, function,
      "#edge of cotan weight zero", "random 1-forms divide by the weights, take tree and cotree");

  const Topology t = topology(mesh);
  const bool is_closed = t.boundary_loops == 0;
  const int count = 2 * t.genus + (is_closed ? 0 : t.boundary_loops - 1);
  std::mt19937_64 random(seed);
  Eigen::MatrixXd alpha(mesh.size_of_edges(), count);
  if (count == 0) return alpha;
  for (double& value : alpha.reshaped())
    value = std::ldexp(static_cast<double>(random() >> 11), -52) - 1;

  const Eigen::SparseMatrix<double> d1 = exterior_derivative_1(mesh);
  // Without boundary, the sum of all rows is zero, and constants are the kernel: row and column 0
  // are left out.
  const Eigen::SparseMatrix<double> part = d1.bottomRows(mesh.size_of_faces() - is_closed);
  const Eigen::SparseMatrix<double> laplacian =
      part * w.cwiseInverse().asDiagonal() * part.transpose();
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(laplacian);
  assert(factor.info() == Eigen::Success);
  for (int pass = 0; pass < 2; ++pass)  // the second removes what rounding has left
    alpha -= w.cwiseInverse().asDiagonal() *
             (part.transpose() * factor.solve(Eigen::MatrixXd(part * alpha)));
  return alpha;
}

}  // namespace Conformal_geometry_processing

#endif
