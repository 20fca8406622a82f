// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/conformal_modulus.h>

#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

std::complex<double> reduced_modulus(std::complex<double> tau)
{
  const double rounding = 1e-12;
  for (;;) {
    tau -= std::round(tau.real());
    if (std::norm(tau) >= 1 - rounding) return tau;
    tau = -1. / tau;  // Im tau grows, so the loop terminates
  }
}

std::complex<double> conformal_modulus(const Mesh_view& mesh, const Harmonic_basis& basis)
{
  require_closed(mesh, "conformal_modulus");
  if (basis.genus() != 1)
    throw Precondition_error(
        "conformal_modulus",
        "the surface has genus " + std::to_string(basis.genus()) + "; a torus is needed");
  Eigen::MatrixXd generators = closed_generators(mesh);
  if (wedge_product(mesh, generators.col(0), generators.col(1)) < 0) generators.col(0) *= -1;
  const Eigen::Matrix2d periods =
      basis.one_forms.transpose() * cotan_weights(mesh).asDiagonal() * generators;
  const Eigen::Matrix2d G = periods.transpose() * periods;
  return reduced_modulus({-G(0, 1) / G(1, 1), std::abs(periods.determinant()) / G(1, 1)});
}

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
