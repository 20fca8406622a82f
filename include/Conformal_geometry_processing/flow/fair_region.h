// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Fairing_patch.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <functional>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// Options of `conformal_fairing()`
struct Fairing_options {
  bool exact_conformal_class = true;  ///< whether the region stays in its conformal class
  int max_steps = 100;
  double tolerance = 1e-5;  ///< of the way of a vertex in a step, by the diagonal of the region
};

/// \brief The numbers that verify `conformal_fairing()`.
struct [[nodiscard]] Fairing_report {
  bool converged = false;  ///< no step moves a vertex by more than the tolerance
  std::string message;     ///< why not
  int steps = 0;           ///< taken
  int free_vertices = 0;   ///< of the region; the others are held

  /// the Willmore energy of the region and its rim, the integral of H^2
  double initial_energy = 0, energy = 0;
  Normal_jump initial_normal_jump, normal_jump;  ///< at the rim
  Conformality conformality;  ///< of the map from the old faces that move to the new ones

  /// whether the surface is as smooth as possible; if not, it is the last one, smoother than before
  explicit operator bool() const { return converged; }
};

struct Fairing_result {
  Points positions;  ///< of all vertices of the mesh; held ones are bitwise what they were
  Fairing_report report;
};

/// \brief Replaces a region of a surface by the smoothest one with the same rim and normals there,
/// see `conformal_fairing()`.
///
/// Starts at the region itself, or, if the class is not kept, where `Outline_fairing` does.
/// \param is_in_region one entry for each face
/// \param go_further is asked before every step; false ends the fairing with the last surface
/// \throw Precondition_error if the mesh is not a manifold with finite positions, or as
/// `Fairing_patch`
/// \throw Solver_error if memory does not suffice; another failure ends the fairing with the last
/// surface, see `Fairing_report::message`
Fairing_result fair_region(const Mesh_view& mesh, const std::vector<char>& is_in_region,
                           const Fairing_options& options, const std::string& function,
                           const std::function<bool()>& go_further);

}  // namespace Conformal_geometry_processing::internal
