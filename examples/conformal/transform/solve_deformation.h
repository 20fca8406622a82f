// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "solve_spin.h"

#include <Conformal_geometry_processing/spin/Conformal_deformation.h>
#include <Conformal_geometry_processing/spin/Control_point.h>

#include <functional>
#include <vector>

namespace conformal {

/// a conformal deformation that moves control points
struct Deformation_problem {
  std::vector<CGP::internal::Control_point> points;  ///< with targets in units of the mesh
  CGP::internal::Conformal_deformation_options request;
};

/// what came of it
struct Deformation_solution {
  Spin_solution spin;
  CGP::Curvature_potential rho;  ///< that was found, in 1/length of the mesh, on vertices
  Eigen::VectorXd region;        ///< weights of the parts of it that moved; empty without one
};

/// Calls the library's `Conformal_deformation`.
Deformation_solution solve_deformation(
    const CGP::Mesh_view& mesh, const Deformation_problem& problem,
    const std::function<bool(const CGP::Eigensolver_progress&)>& go_further);

}  // namespace conformal
