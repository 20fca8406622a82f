// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// An edit of a surface with handles factors two matrices: X for rho, to find spins, and X for
// rho = 0, to find what keeps handles closed. Would one factor do for both? Prints, for each mesh
// and amplitude, the iterations that either takes with its own factor and with the other one.
//
// usage: benchmark_shared_factor NAME.off ...
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>
#include <Quaternionic_linear_algebra/krylov/conjugate_gradients.h>

#include <cmath>
#include <cstdio>
#include <exception>

#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;
using Potential = CGP::Curvature_potential;
using System = CGP::internal::Dirac_system;
using Vectors = CGP::Block<CGP::Quaternion<double>>;

/// X for rho = 0 knows nothing of constants
Vectors without_mean(Vectors v, const Eigen::VectorXd& areas)
{
  const auto ones =
      CGP::Quaternion_vector<double>::Constant(v.rows(), CGP::Quaternion<double>{1, 0, 0, 0});
  const CGP::Quaternion<double> mean =
      inner_product(ones, CGP::block_operator(areas)(v).col(0)) * (1 / areas.sum());
  for (Eigen::Index i = 0; i < v.rows(); ++i) v(i, 0) = v(i, 0) - mean;
  return v;
}

Vectors smooth_vectors(const CGP::Mesh_view& mesh)
{
  Vectors v(mesh.size_of_vertices(), 1);
  for (Eigen::Index i = 0; i < v.rows(); ++i) {
    const Eigen::Vector3d p = mesh.position(static_cast<int>(i));
    v(i, 0) = {std::sin(3 * p.x()), p.y(), p.z() * p.x(), std::cos(4 * p.z())};
  }
  return v;
}

/// of conjugate gradients for X at rho = 0, whose factor or that of another rho is at hand
int response_iterations(System& system, const Vectors& smooth, const Potential& zero)
{
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.assemble(zero, seconds);
  const Eigen::VectorXd& areas = system.areas();
  const Vectors b = CGP::block_operator(areas)(without_mean(smooth, areas));
  CGP::internal::Conjugate_gradients_options options;
  options.tolerance = 1e-8;
  Vectors x;
  const auto X = [&](const Vectors& v, Vectors& y) { y = system.matrix() * v.col(0); };
  const auto precondition = [&](const Vectors& r, Vectors& z) {
    z = without_mean(system.precondition(r), areas);
  };
  return conjugate_gradients(X, precondition, b, x, options).iterations;
}

/// of the eigensolver for X at rho, from 1
int spin_iterations(System& system, const Potential& rho)
{
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.assemble(rho, seconds);
  const Vectors one = Vectors::Constant(system.areas().size(), 1, {1, 0, 0, 0});
  CGP::Eigensolver_options options;
  options.tolerance = 1e-6;
  options.max_iterations = 500;
  options.scale = std::sqrt(system.unit());
  return CGP::Lobpcg_eigensolver_traits()(system.matrix(), system.areas(), system.solver(), one,
                                          options, CGP::internal::Always_go_further())
      .iterations;
}

void compare(const std::string& path)
{
  const CGP::Mesh_view mesh = make_mesh(path);
  const Vectors smooth = smooth_vectors(mesh);
  System system(mesh);
  CGP::internal::Dirac_evidence::Seconds seconds;
  for (const double amplitude : {.25, .5, 1.}) {
    Potential rho = smooth_potential(mesh, amplitude), zero = rho;
    zero.values.setZero();
    rho.values.array() += CGP::solve_dirac_equation(system, rho).eigenvalue;
    system.set_potential(zero, seconds, System::Use::preconditioner);
    const int spins_by_zero = spin_iterations(system, rho);
    const int responses = response_iterations(system, smooth, zero);
    system.set_potential(rho, seconds, System::Use::preconditioner);
    const int spins = spin_iterations(system, rho);
    std::printf(R"({"mesh": "%s", "amplitude": %g, "spins": [%d, %d], "responses": [%d, %d]})"
                "\n",
                path.substr(path.find_last_of('/') + 1).c_str(), amplitude, spins, spins_by_zero,
                responses, response_iterations(system, smooth, zero));
  }
}

}  // namespace

int main(int argc, char** argv)
{
  for (int k = 1; k < argc; ++k) try {
      compare(argv[k]);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: left out: %s\n", argv[k], e.what());
    }
}
