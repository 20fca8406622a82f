// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/conformal_type.h>

#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Grounded_solver.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace Conformal_geometry_processing {

Eigen::MatrixXd internal::harmonic_energies(const Mesh_view& mesh)
{
  Eigen::MatrixXd forms = closed_generators(mesh);
  if (forms.cols() == 0) return Eigen::MatrixXd(0, 0);
  const Eigen::VectorXd w = cotan_weights(mesh);
  const auto graph = vertex_graph(mesh);
  Grounded_solver laplacian(graph);
  laplacian.factorize(cotan_laplacian(mesh, graph));
  remove_exact_parts(mesh, w, laplacian, forms);
  return forms.transpose() * w.asDiagonal() * forms;
}

double internal::conformal_type_distance(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B)
{
  if (A.size() == 0) return 0;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> pencil(B, A,
                                                                         Eigen::EigenvaluesOnly);
  const auto& t = pencil.eigenvalues();
  const bool is_good = pencil.info() == Eigen::Success && t.allFinite() && t.minCoeff() > 0;
  return is_good ? std::log(t.maxCoeff() / t.minCoeff()) / 2 : HUGE_VAL;
}

}  // namespace Conformal_geometry_processing
