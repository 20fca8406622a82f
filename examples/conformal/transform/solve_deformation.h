// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "solve_spin.h"

#include <Conformal_geometry_processing/spin/Control_point.h>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace conformal {

/// a conformal deformation that moves control points
struct Deformation_problem {
  std::vector<CGP::internal::Control_point> points;  ///< with targets in units of the mesh
  std::optional<double> scale_bound;
  std::optional<double> position_weight;  ///< none: exact
  double mollification = 0;               ///< if not 0, on the intrinsic Delaunay triangulation
  Eigen::VectorXd region;  ///< weights of the vertices in a region of interest; empty: all may move
};

/// what came of it
struct Deformation_solution {
  Spin_solution spin;
  CGP::Curvature_potential rho;  ///< that was found, in 1/length of the mesh, on vertices
};

/// Calls the library's `Conformal_deformation`.
Deformation_solution solve_deformation(
    const CGP::Mesh_view& mesh, const Deformation_problem& problem,
    const std::function<bool(const CGP::Eigensolver_progress&)>& go_further);

}  // namespace conformal
