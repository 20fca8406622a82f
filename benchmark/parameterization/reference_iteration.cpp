// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <vector>

#include "parameterization/Method.h"

namespace cgp_benchmark {
namespace {

namespace CGP = Conformal_geometry_processing;

const int vectors = 8, steps = 60;

/// \brief The first of eight vectors computed by the reference for the energy with vertex normals:
/// inverse iteration with the identity as shift, projection orthogonal to the constants after each
/// step, and the Rayleigh-Ritz method for the energy on the rest.
Eigen::VectorXd reference_iteration(const CGP::Mesh_view& mesh)
{
  const auto graph = CGP::vertex_graph(mesh);
  const auto L = CGP::vertex_normal_energy(
      mesh, CGP::vertex_normals(mesh, CGP::internal::Normal_weight::angle), *graph);
  const int n = L.size();
  double trace = 0;
  for (int i = 0; i < n; ++i) trace += L.diagonal(i);
  CGP::Supernodal_cholesky<double> solver;
  (void)solver.analyze(L.pattern(), CGP::expanded_ordering(CGP::amd_ordering(*graph), 2));
  (void)solver.factorize(L, Eigen::VectorXd::Constant(n, 1e-10 * trace / n));

  const std::vector<char> is_boundary = CGP::boundary_vertices(mesh);
  Eigen::VectorXd mass(n);
  for (int i = 0; i < n; ++i) mass[i] = is_boundary[static_cast<std::size_t>(i / 2)];
  Eigen::MatrixXd constants = Eigen::MatrixXd::Zero(n, 2), x = Eigen::MatrixXd::Random(n, vectors);
  for (int i = 0; i < n; ++i) constants(i, i % 2) = 1 / std::sqrt(mass.sum() / 2);
  const auto take_out_constants = [&] {
    const Eigen::MatrixXd along = constants.transpose() * (mass.asDiagonal() * x);
    x -= constants * along;
  };
  take_out_constants();
  for (int step = 0; step < steps; ++step) {
    Eigen::MatrixXd y;
    (void)solver.solve(mass.asDiagonal() * x, y);
    x = y;
    take_out_constants();
    Eigen::MatrixXd Lx(n, vectors);
    for (int k = 0; k < vectors; ++k) Lx.col(k) = L * x.col(k);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
        x.transpose() * Lx, x.transpose() * (mass.asDiagonal() * x));
    x *= Eigen::MatrixXd(ritz.eigenvectors());
  }
  return x.col(0);
}

}  // namespace

Method reference_method()
{
  return {"normals of vertices, as the reference", [](Surface& mesh, Border, UV_map uv) {
            const CGP::Graph_view<Surface> graph(mesh, CGP::parameters::default_values(), "");
            const Eigen::VectorXd ab = reference_iteration(graph.view());
            for (int v = 0; v < graph.view().size_of_vertices(); ++v)
              uv[graph.vertex(v)] = {ab[2 * v], ab[2 * v + 1]};
            return std::string("OK");
          }};
}

}  // namespace cgp_benchmark
