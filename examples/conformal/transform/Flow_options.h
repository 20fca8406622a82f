// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Flow_options.h>

#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

enum class Connectivity { keep, delaunay };

struct Flow_options {
  Flow_options() { request.max_steps = 10; }

  std::string input;
  CGP::Flow_options request;
  int every = 0;  ///< steps from a snapshot to the next; none if zero
  Connectivity connectivity = Connectivity::keep;
  bool force = false;
};

}  // namespace conformal
