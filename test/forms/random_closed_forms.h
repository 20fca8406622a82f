// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <Eigen/SparseLU>

#include <cassert>
#include <cmath>
#include <random>

#include "support/meshes.h"

namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

/// \brief random 1-forms without their co-exact parts, the generators that the thesis starts from
/// [CGP 6.4.5.1]: gamma = alpha - w^-1 d1^T b with d1 w^-1 d1^T b = d1 alpha for random alpha in
/// [-1, 1). The library takes those of spanning trees, which need no weights.
/// \returns |E| x 2G, or 2G + loops - 1 with a boundary; almost surely no combination is exact
/// \throw Precondition_error if a weight is zero, as they are opposite right angles
inline Eigen::MatrixXd random_closed_forms(const Mesh_view& mesh, unsigned seed)
{
  const double least_weight = 1e-12;
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  CGP::internal::refuse_if_any(
      mesh.size_of_edges(), [&](int k) { return !(std::abs(w[k]) > least_weight); },
      [&](int k) { return CGP::internal::name_of_edge(mesh, k); }, "random_closed_forms",
      "#edge of cotan weight zero", "random 1-forms divide by the weights, take tree and cotree");

  const CGP::internal::Topology t = CGP::topology(mesh);
  const bool is_closed = t.boundary_loops == 0;
  const int count = 2 * t.genus + (is_closed ? 0 : t.boundary_loops - 1);
  std::mt19937_64 random(seed);
  Eigen::MatrixXd alpha(mesh.size_of_edges(), count);
  if (count == 0) return alpha;
  for (double& value : alpha.reshaped())
    value = std::ldexp(static_cast<double>(random() >> 11), -52) - 1;

  const Eigen::SparseMatrix<double> d1 = CGP::exterior_derivative_1(mesh);
  // Without boundary, the rows sum up to zero and the kernel consists of the constants: row and
  // column 0 are left out.
  const Eigen::SparseMatrix<double> part = d1.bottomRows(mesh.size_of_faces() - is_closed);
  const Eigen::SparseMatrix<double> laplacian =
      part * w.cwiseInverse().asDiagonal() * part.transpose();
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(laplacian);
  assert(factor.info() == Eigen::Success);
  for (int pass = 0; pass < 2; ++pass)  // the second pass removes rounding errors
    alpha -= w.cwiseInverse().asDiagonal() *
             (part.transpose() * factor.solve(Eigen::MatrixXd(part * alpha)));
  return alpha;
}

}  // namespace cgp_test
