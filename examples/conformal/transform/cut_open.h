// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Surface_input.h"
#include "conformal/repair/Corner_fans.h"

#include <Conformal_geometry_processing/parameterization/cones.h>

#include <Eigen/Core>

#include <vector>

namespace conformal {

using CGP::internal::Cone;

/// where closed surfaces are cut, and those with a boundary for a flat metric
struct Cut_options {
  int tips = 0;             ///< how many are looked for, on each component; 0: it is not cut
  bool finds_tips = false;  ///< twice as many, where the image does not verify with them
  std::vector<Cone> cones;  ///< vertices of the file that the cut reaches, in place of tips
  bool makes_flat = false;  ///< gives the surface a metric that is flat outside the cones

  bool opens_closed() const { return tips > 0 || !cones.empty(); }
};

/// A surface whose vertices have copies along cuts
struct Cut_surface {
  Surface_input input;
  std::vector<int> origin;  ///< of each vertex of `input.file`: its number in the file before
  Eigen::VectorXd
      log_scale;            ///< of the flat metric, at the vertices of `input.mesh`, if it is made
  std::vector<Cone> cones;  ///< of that, at vertices of the file before
};

/// \brief Gives each side of edges its own vertices.
/// \param cuts by the vertices of the file
/// \returns the surface, without a metric
Cut_surface cut_along(Surface_file file, std::vector<Corner_fans::Edge> cuts);

/// \brief Cuts closed components to disks, and for a flat metric those with a boundary, too, along
/// the edges of the file; see `cut_graph()`.
/// \throws Failure if a cone is not an inner vertex of such a component, or alone on a sphere, or
/// if the angles of cones do not fit the surface
Cut_surface cut_open(const Surface_input& input, const Cut_options& options);

}  // namespace conformal
