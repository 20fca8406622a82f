// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "commands.h"

namespace conformal {

std::vector<Command> commands()
{
  // clang-format off
  return {
      info_command(),
      spin_command(),
      deform_command(),
      fair_command(),
      flow_command(),
      boundary_command(),
      fit_command(),
      blend_command(),
      flatten_command(),
      curve_command(),
      harmonic_command(),
      spectrum_command(),
      sphere_command(),
      compare_command(),
      split_command(),
      studio_command(),
  };
  // clang-format on
}

}  // namespace conformal
