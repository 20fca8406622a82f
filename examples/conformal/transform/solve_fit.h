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
  Eigen::VectorXd scales;              ///< factors for the scales of the target; none if empty
  Eigen::Vector3d direction{1, 0, 0};  ///< of the boundary frame, which becomes the target's
  double blend = 0;                    ///< 0 is conformal, 1 nearest to the target
  bool keep_curvature = false;         ///< that of the target, wherever the surface is then
  double normal_weight = 1;            ///< how much normals count beside positions
  std::optional<double> shear;         ///< the largest closure residual of the search
  double distance_tolerance = CGP::Nearest_spin_options().distance_tolerance;  ///< search's end
  std::optional<double> scale_bound;  ///< on factors of lengths
  double mollification = 0;           ///< if not 0, on the intrinsic Delaunay triangulation
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
                       const Common_options& common,
                       const std::function<bool(const CGP::Eigensolver_progress&)>& go_further);

}  // namespace conformal
