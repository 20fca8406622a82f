// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/exactness_functions.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <cmath>
#include <optional>
#include <vector>

#include "support/mesh_tools.h"

/// How well transformed edges close up, with and without constraints.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;
using On = CGP::Curvature_potential::On;

/// a mesh with all that its constraints need
struct Exactness_case {
  Mesh_view mesh;
  CGP::Hodge_decomposition hodge{mesh};
  CGP::internal::Dirac_system system{mesh};

  explicit Exactness_case(Mesh_view mesh_) : mesh(std::move(mesh_)) { system.prepare_response(); }
  Exactness_case(const Exactness_case&) = delete;

  Eigen::MatrixXd constraints(On on, CGP::Exactness version = CGP::Exactness::adjoint) const
  {
    return CGP::exactness_functions(
        mesh, hodge.harmonic_basis(), [this](const auto& c) { return system.response(c); }, on,
        CGP::internal::Coefficients::quaternions, version);
  }

  Eigen::VectorXd areas(On on) const
  {
    return on == On::vertices ? CGP::vertex_areas(mesh) : CGP::face_areas(mesh);
  }

  /// -H without its part along the constants and the constraints
  Eigen::VectorXd direction(On on, std::optional<CGP::Exactness> version) const
  {
    const Eigen::VectorXd H = CGP::mean_curvature(mesh), m = areas(on);
    Eigen::VectorXd v = -H;
    if (on == On::faces) {
      v.resize(mesh.size_of_faces());
      for (int f = 0; f < mesh.size_of_faces(); ++f) {
        const auto& c = mesh.corners(f);
        v[f] = -(H[c[0]] + H[c[1]] + H[c[2]]) / 3;
      }
    }
    Eigen::MatrixXd functions = Eigen::MatrixXd::Ones(v.size(), 1);
    if (version) {
      const Eigen::MatrixXd z = constraints(on, *version);
      functions.conservativeResize(Eigen::NoChange, 1 + z.cols());
      functions.rightCols(z.cols()) = z;
    }
    return CGP::project_out(CGP::weighted_orthonormalization(functions, m), m, v);
  }

  /// the edges of the surface that rho leads to
  Eigen::MatrixXd edges_for(On on, const Eigen::VectorXd& rho) const
  {
    CGP::Dirac_options options;
    options.tolerance = 1e-11;
    CGP::internal::Dirac_system own(mesh);
    const auto solution = CGP::solve_dirac_equation(own, {on, rho}, options);
    return CGP::transformed_edges(mesh, solution.lambda);
  }

  /// the norm of their harmonic part relative to their own
  double harmonic_share(On on, const Eigen::VectorXd& rho) const
  {
    const Eigen::MatrixXd edges = edges_for(on, rho);
    const double squared = edges.cwiseProduct(hodge.weights().asDiagonal() * edges).sum();
    return hodge.harmonic_part().coefficients(edges).norm() / std::sqrt(squared);
  }

  std::vector<double> harmonic_shares(On on, std::optional<CGP::Exactness> version,
                                      const std::vector<double>& steps) const
  {
    const Eigen::VectorXd v = direction(on, version);
    std::vector<double> shares;
    for (const double tau : steps) shares.push_back(harmonic_share(on, tau * v));
    return shares;
  }
};

}  // namespace cgp_test
