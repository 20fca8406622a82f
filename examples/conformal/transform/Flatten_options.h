// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "cut_open.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

enum class Flatten_method { spectral, dirac, cones };

struct Flatten_options {
  std::string input;
  Flatten_method method = Flatten_method::spectral;
  bool planar = false;       ///< by curvature instead
  bool planar_mesh = false;  ///< writes the flat mesh
  Cut_options cut;           ///< of closed surfaces
  bool all_loops = false;    ///< the spread of all boundary loops is kept
  double tolerance = 1e-6;   ///< of the spectral map
  bool force = false;
  CGP::Spin_report::Limits limits;
};

}  // namespace conformal
