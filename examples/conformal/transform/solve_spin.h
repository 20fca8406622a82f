// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <functional>
#include <optional>
#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// whether to go on, asked after each iteration of the eigensolver
using Go_further = std::function<bool(const CGP::Eigensolver_progress&)>;

/// The problem for the library, in units of the mesh
struct Spin_problem {
  CGP::Curvature_potential rho;
  CGP::Spin_transformation_options request;
  bool minimal = false;                             ///< rho is -H, and gamma has to be zero
  std::optional<double> second_try = std::nullopt;  ///< see `Spin_options`
};

/// \throws Failure if the program was built without the solver of this name
CGP::Spin_solvers solvers_named(const std::string& name);

/// Calls the library's `Spin_transformation`, or `spin_to_minimal_surface()`.
CGP::Spin_result solve_spin(const CGP::Mesh_view& mesh, const Spin_problem& problem,
                            const Go_further& go_further);

}  // namespace conformal
