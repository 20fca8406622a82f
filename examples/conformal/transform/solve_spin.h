// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Spin_options.h"

#include "conformal/process/Common_options.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <functional>
#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// whether to go on, asked after each iteration of the eigensolver
using Go_further = std::function<bool(const CGP::Eigensolver_progress&)>;

/// Result of the library: new positions, lambda and the certificate
struct Spin_solution {
  CGP::Points positions;
  CGP::Quaternion_vector<double> lambda;
  CGP::Spin_report report;
  std::string note = {};  ///< changes that were not requested, empty if none
};

/// The problem for the library, in units of the mesh
struct Spin_problem {
  CGP::Curvature_potential rho;
  CGP::Boundary_condition boundary;
  bool minimal = false;      ///< rho is -H, and gamma has to be zero
  double mollification = 0;  ///< if not 0, on the intrinsic Delaunay triangulation
  double second_try = 0;     ///< the mollification where a result without does not verify; 0: none
  CGP::internal::Scale_control scales = {};
  bool exact_class = false;  ///< length cross-ratios are kept to rounding
  bool closes_loops = true;  ///< in as many steps as it takes; leaves out what opens them
};

/// Calls the library's `Spin_transformation`, or `spin_to_minimal_surface()`, with the solver that
/// the options name.
Spin_solution solve_spin(const CGP::Mesh_view& mesh, const Spin_problem& problem,
                         const Spin_options& options, const Common_options& common,
                         const Go_further& go_further);

}  // namespace conformal
