// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <array>
#include <string>
#include <vector>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// places on a checkerboard at the corners of the faces, corner c of face f at 3 f + c
using Corner_places = std::vector<std::array<double, 2>>;

/// The shapes to be shown: a surface before and after, and squares on the former that are mapped to
/// the latter. Each shape has its own frame.
struct Exhibit {
  CGP::Mesh_view before;
  CGP::Points after;
  Corner_places squares;
  std::string kind_of_squares;  ///< their origin, for the user
  Eigen::VectorXd rho = {};     ///< of each face, in the user's frame; none if empty
};

}  // namespace conformal
