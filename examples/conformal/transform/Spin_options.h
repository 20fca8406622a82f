// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Rho_options.h"

#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <optional>
#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Control of scale beside a bound: at most one of each pair of sources is not empty
struct Scale_options {
  std::string target_expression, target_property;  ///< wanted factors
  std::string lock_expression, lock_property;      ///< positive where sizes have to stay
};

struct Spin_options {
  std::string input;
  Rho_options rho;
  CGP::Spin_transformation_options request;  ///< but for what depends on the surface
  Scale_options scales;
  /// the mollification where a result without does not verify, if any
  std::optional<double> second_try;
  std::string lambda;  ///< the name of the vertex properties, none if empty
  bool force = false;
};

}  // namespace conformal
