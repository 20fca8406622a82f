// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_boundary.h"

#include "Distributed_matrix.h"

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>

#include <cstddef>

namespace conformal::mpi {
namespace {

using CGP::Quaternion;
using CGP::Quaternion_vector;
using Embedding = CGP::internal::Complex_embedding<Quaternion<double>>;

/// |A x - b| / |b|
double residual(Mat A, Vec b, Vec x)
{
  Petsc_vec rest;
  PetscReal numerator = 0, denominator = 0;
  check_petsc(VecDuplicate(b, rest.renew()));
  check_petsc(MatResidual(A, b, x, rest.get()));
  check_petsc(VecNorm(rest.get(), NORM_2, &numerator));
  check_petsc(VecNorm(b, NORM_2, &denominator));
  return numerator / denominator;
}

/// the spins of the vertices of the part, from those of the own ones
Quaternion_vector<double> spins_of(const Distributed_mesh& mesh, Vec x)
{
  Eigen::MatrixXd parts(4, mesh.mesh().size_of_vertices());
  with_values(x, [&](const PetscScalar* values) {
    for (int v = 0; v < mesh.own_vertices(); ++v, values += 2) {
      const Quaternion<double> q = Embedding::from_entries(values);
      parts.col(v) = Eigen::Vector4d(q.w, q.x, q.y, q.z);
    }
  });
  mesh.update(parts);
  Quaternion_vector<double> lambda(parts.cols());
  CGP::components(lambda) = parts;
  return lambda;
}

}  // namespace

Quaternion_vector<double> spins_with_free_boundary(const Distributed_mesh& mesh,
                                                   const Solution_plan& plan,
                                                   const Eigen::VectorXd& rho,
                                                   const Eigen::VectorXd& areas,
                                                   CGP::Spin_report& report)
{
  CGP::internal::Stopwatch watch;
  const auto potential = CGP::Curvature_potential::on_vertices(rho);
  const Eigen::VectorXd weights = CGP::nearness_weight(mesh.mesh(), mesh.part()) * areas;
  auto A = CGP::dirac_energy(mesh.mesh(), potential);
  for (int v = 0; v < mesh.own_vertices(); ++v)
    A.value(A.pattern().offsets[static_cast<std::size_t>(v)]).w += weights[v];
  Distributed_matrix<Quaternion<double>> matrix(mesh);
  matrix.set(A);
  report.seconds.assembly += watch.lap();
  const Distributed_solver<Quaternion<double>> solver(mesh, plan, matrix.get(), A);
  report.factorizations = 1;
  report.seconds.factorization += watch.lap();
  const Petsc_vec b = matrix.make_vector(), x = matrix.make_vector();
  with_values(b.get(), [&](PetscScalar* values) {
    for (int v = 0; v < mesh.own_vertices(); ++v, values += 2)
      Embedding::to_entries({weights[v], 0, 0, 0}, values);
  });
  solver.solve(b.get(), x.get());
  report.solves = 1;
  report.residual = residual(matrix.get(), b.get(), x.get());
  Quaternion_vector<double> lambda = spins_of(mesh, x.get());
  report.seconds.eigenvectors += watch.lap();
  report.eigenvalue = CGP::dirac_misfit(mesh.mesh(), potential, lambda, mesh.part());
  report.converged = true;
  return lambda;
}

}  // namespace conformal::mpi
