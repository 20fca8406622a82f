// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_SPIN_BRANCH_TOOLS_H
#define TEST_SPIN_BRANCH_TOOLS_H

#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "support/meshes.h"

/// Strong potentials, and the branch of the identity followed in steps too small to lose it.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

inline Curvature_potential smooth_potential(const Mesh_view& mesh, double amplitude)
{
  return Curvature_potential::on_vertices(amplitude * rho_of_section_3_on_vertices(mesh));
}

/// 40 Gaussians of width 0.2 at random places of the unit sphere, with random signs
inline Curvature_potential bumps_potential(const Mesh_view& mesh, double amplitude)
{
  Random random(1);
  Eigen::VectorXd rho = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int k = 0; k < 40; ++k) {
    const Eigen::Vector3d center = random.vector().normalized();
    const double sign = random.number() < 0 ? -1 : 1;
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      rho[v] +=
          sign * amplitude * std::exp(-(mesh.position(v) - center).squaredNorm() / (2 * 0.2 * 0.2));
  }
  return Curvature_potential::on_vertices(std::move(rho));
}

inline Curvature_potential scaled(const Curvature_potential& rho, double t, double shift)
{
  return {rho.on, (t * rho.values.array() + shift).matrix()};
}

/// an eigenvector with its signed eigenvalue
struct Branch_point {
  Quaternion_vector<double> lambda;
  double gamma;
  double least_overlap;  ///< of two steps that follow one another
};

/// Brute force: rho is switched on in `steps` equal steps. Each takes, of the eigenvectors of
/// D - (t rho + gamma) with gamma the last eigenvalue, the one that overlaps most with the last.
inline Branch_point branch_of_identity(CGP::Dirac_eigenproblem<>& problem,
                                       const Curvature_potential& rho, int steps)
{
  const Mesh_view& mesh = problem.mesh();
  Branch_point at{Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 0, 0, 0}), 0, 1};
  for (int k = 1; k <= steps; ++k) {
    const double t = double(k) / steps;
    CGP::Dirac_solution::Seconds seconds;
    problem.set_potential(scaled(rho, t, at.gamma), seconds);
    const auto found =
        problem.smallest(problem.start(at.lambda, 0), 2, 1e-4, 200, CGP::Always_go_further());
    const Quaternion_vector<double> a = found.vectors.col(0), b = found.vectors.col(1);
    const Quaternion_vector<double> next =
        problem.overlap(a, at.lambda) > problem.overlap(b, at.lambda) ? a : b;
    at.least_overlap = std::min(at.least_overlap, problem.overlap(next, at.lambda));
    at.lambda = next;
    at.gamma = CGP::dirac_quotient(mesh, scaled(rho, t, 0), next);
  }
  return at;
}

/// the eigenvector of the smallest eigenvalue of X, whatever its branch
inline Quaternion_vector<double> smallest_eigenvector(CGP::Dirac_eigenproblem<>& problem,
                                                      const Curvature_potential& rho)
{
  CGP::Dirac_solution::Seconds seconds;
  problem.set_potential(rho, seconds);
  const auto one =
      Quaternion_vector<double>::Constant(problem.mesh().size_of_vertices(), {1, 0, 0, 0});
  return problem.smallest(problem.start(one, 0), 1, 1e-6, 200, CGP::Always_go_further())
      .vectors.col(0);
}

}  // namespace cgp_test

#endif
