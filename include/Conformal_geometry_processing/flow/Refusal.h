// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Flow_report.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing::internal {

/// \brief why a flow does not take a surface, and where.
struct Refusal {
  std::string reason;       ///< empty: it is taken
  Eigen::VectorXd measure;  ///< |V|, largest where the reason is; empty: at no single place

  explicit operator bool() const { return !reason.empty(); }
};

/// \brief the limit that a map exceeds, with its number; where the map has the largest
/// quasi-conformal error, the largest face is flipped, or lengths have become shortest.
Refusal beyond_limits(const Mesh_view& mesh, const Points& positions, const Conformality& map,
                      const Conformality::Limits& limits);

/// \brief by how much the Willmore energy of each vertex grows, |V|.
Eigen::VectorXd energy_growth(const Mesh_view& before, const Mesh_view& after);

/// \brief the largest quasi-conformal error of the faces at each vertex, |V|.
Eigen::VectorXd distortion_at_vertices(const Mesh_view& mesh, const Points& positions);

/// \brief the largest change of the logarithm of a length cross-ratio at each vertex, |V|.
Eigen::VectorXd misfit_of_class(const Mesh_view& mesh, const Points& positions);

/// \brief minus the least angle of the faces at each vertex, |V|, in radians.
Eigen::VectorXd thinness(const Mesh_view& mesh);

/// \brief where a measure is largest, or is no number.
/// \param input of whose faces there the thinnest one is named
Flow_step_report::Place place_of(const Mesh_view& input, const Eigen::VectorXd& measure);

}  // namespace Conformal_geometry_processing::internal
