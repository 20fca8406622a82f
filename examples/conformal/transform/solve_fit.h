// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "solve_spin.h"

#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>

#include <functional>
#include <optional>

namespace conformal {

/// a conformal deformation near to a given one
struct Fit_problem {
  CGP::Points target;
  Eigen::VectorXd scales;  ///< factors for the scales of the target; none if empty
  double blend = 0;        ///< 0 is conformal, 1 nearest to the target
  CGP::Nearest_spin_options request;
};

/// what came of it
struct Fit_solution {
  Spin_solution spin;
  CGP::Curvature_potential rho;              ///< of the result, in 1/length of the mesh
  double distance = 0;                       ///< from the target, rms relative to the diagonal
  double source_distance = 0;                ///< likewise of the mesh
  double normal_distance = 0;                ///< of face normals from the target's, rms
  double source_normal_distance = 0;         ///< likewise of the mesh
  std::optional<Eigen::Vector3d> direction;  ///< at the boundary; none: it was left free
  int sign_conflicts = 0;  ///< edges across which the rotations of the target jump
};

/// Calls the library's `Nearest_spin_transformation`. This is the one place that compiles it.
Fit_solution solve_fit(const CGP::Mesh_view& mesh, const Fit_problem& problem,
                       const std::function<bool(const CGP::Eigensolver_progress&)>& go_further);

}  // namespace conformal
