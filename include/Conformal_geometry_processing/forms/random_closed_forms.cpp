// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/random_closed_forms.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/exterior_derivative.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <cassert>
#include <cmath>
#include <random>
#include <string>

namespace Conformal_geometry_processing {

Eigen::MatrixXd random_closed_forms(const Mesh_view& mesh, unsigned seed,
                                    const std::string& function)
{
  const double least_weight = 1e-12;
  const Eigen::VectorXd w = cotan_weights(mesh);
  internal::refuse_if_any(
      mesh.size_of_edges(), [&](int k) { return !(std::abs(w[k]) > least_weight); },
      [&](int k) { return internal::name_of_edge(mesh, k); }, function,
      "#edge of cotan weight zero", "random 1-forms divide by the weights, take tree and cotree");

  const internal::Topology t = topology(mesh);
  const bool is_closed = t.boundary_loops == 0;
  const int count = 2 * t.genus + (is_closed ? 0 : t.boundary_loops - 1);
  std::mt19937_64 random(seed);
  Eigen::MatrixXd alpha(mesh.size_of_edges(), count);
  if (count == 0) return alpha;
  for (double& value : alpha.reshaped())
    value = std::ldexp(static_cast<double>(random() >> 11), -52) - 1;

  const Eigen::SparseMatrix<double> d1 = exterior_derivative_1(mesh);
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

}  // namespace Conformal_geometry_processing
