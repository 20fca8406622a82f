// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_SOLVE_SPIN_H
#define CONFORMAL_SOLVE_SPIN_H

#include "Options.h"

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/linear_algebra/Eigen_result.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <functional>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// what the library computes: new positions, lambda and the certificate
struct Spin_solution {
  CGP::Points positions;
  CGP::Quaternion_vector<double> lambda;
  CGP::Spin_report report;
};

/// Calls the library's `Spin_transformation` with the solver that the options name. This is the one
/// place that compiles it.
/// \param rho in 1/length of the mesh
Spin_solution solve_spin(const CGP::Mesh_view& mesh, const CGP::Curvature_potential& rho,
                         const Spin_options& options, const Common_options& common,
                         const std::function<bool(const CGP::Eigen_progress&)>& go_further);

}  // namespace conformal

#endif
