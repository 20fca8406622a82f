// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

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

inline Quaternion_vector<double> identity_spins(const Mesh_view& mesh)
{
  return Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 0, 0, 0});
}

/// the smallest eigenpairs of X, as many as `start` has columns, of which `wanted` converge
inline CGP::Eigensolver_result smallest(const CGP::internal::Dirac_system& system,
                                        CGP::Block<Quaternion<double>> start, int wanted,
                                        double tolerance, int max_iterations = 200)
{
  CGP::Eigensolver_options options;
  options.wanted = wanted;
  options.tolerance = tolerance;
  options.max_iterations = max_iterations;
  options.scale = std::sqrt(system.unit());
  return CGP::Lobpcg_eigensolver_traits()(system.matrix(), system.areas(), system.solver(),
                                          std::move(start), options,
                                          CGP::internal::Always_go_further());
}

/// the guide, and a vector to be improved
inline CGP::Block<Quaternion<double>> guide_and_noise(const CGP::internal::Dirac_system& system,
                                                      const Quaternion_vector<double>& guide)
{
  CGP::Block<Quaternion<double>> both(guide.size(), 2);
  both << guide, system.noise(1, 0);
  return both;
}

/// an eigenvector with its signed eigenvalue
struct Branch_point {
  Quaternion_vector<double> lambda;
  double gamma;
  double least_overlap;  ///< of two steps that follow one another
};

/// Brute force: rho is switched on in `steps` equal steps. Each takes, of the eigenvectors of
/// D - (t rho + gamma) with gamma the last eigenvalue, the one that overlaps most with the last.
inline Branch_point branch_of_identity(CGP::internal::Dirac_system& system,
                                       const Curvature_potential& rho, int steps)
{
  const auto one = Quaternion_vector<double>::Constant(system.areas().size(), {1, 0, 0, 0});
  Branch_point at{one, 0, 1};
  for (int k = 1; k <= steps; ++k) {
    const double t = double(k) / steps;
    CGP::internal::Dirac_evidence::Seconds seconds;
    system.set_potential(scaled(rho, t, at.gamma), seconds);
    const auto found = smallest(system, guide_and_noise(system, at.lambda), 2, 1e-4);
    const Quaternion_vector<double> a = found.vectors.col(0), b = found.vectors.col(1);
    const Quaternion_vector<double> next =
        system.overlap(a, at.lambda) > system.overlap(b, at.lambda) ? a : b;
    at.least_overlap = std::min(at.least_overlap, system.overlap(next, at.lambda));
    at.lambda = next;
    at.gamma = CGP::dirac_quotient(system.surface(), scaled(rho, t, 0), next);
  }
  return at;
}

/// Brute force: at a point where X(rho + gamma) has an eigenvector near, the one whose own quotient
/// is the shift. sigma <- gamma converges, on the coarsest meshes by one bit a step.
inline Branch_point settled(CGP::internal::Dirac_system& system, const Curvature_potential& rho,
                            Branch_point at)
{
  double last = at.gamma + 1;
  for (int k = 0; k < 60 && std::abs(at.gamma - last) > 1e-9; ++k) {
    CGP::internal::Dirac_evidence::Seconds seconds;
    system.set_potential(scaled(rho, 1, at.gamma), seconds);
    at.lambda = smallest(system, guide_and_noise(system, at.lambda), 1, 1e-9).vectors.col(0);
    last = at.gamma;
    at.gamma = CGP::dirac_quotient(system.surface(), rho, at.lambda);
  }
  return at;
}

/// the eigenvector of the smallest eigenvalue of X, whatever its branch
inline Quaternion_vector<double> smallest_eigenvector(CGP::internal::Dirac_system& system,
                                                      const Curvature_potential& rho)
{
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.set_potential(rho, seconds);
  const auto one = Quaternion_vector<double>::Constant(system.areas().size(), {1, 0, 0, 0});
  return smallest(system, guide_and_noise(system, one), 1, 1e-6).vectors.col(0);
}

}  // namespace cgp_test
