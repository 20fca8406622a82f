// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMAND_LINE_H
#define CONFORMAL_COMMAND_LINE_H

#include "conformal/commands/Options.h"
#include "conformal/commands/Spectrum_options.h"
#include "conformal/curves/Curve_options.h"
#include "conformal/process/Common_options.h"

#include <string>
#include <variant>

namespace conformal {

/// The parsed command line
struct Command_line {
  Common_options common;
  std::string command;
  std::variant<std::monostate, Info_options, Spin_options, Flow_options, Boundary_options,
               Fit_options, Blend_options, Flatten_options, Curve_options, Harmonic_options,
               Compare_options, Spectrum_options, Sphere_options>
      options;
  std::string answer;  ///< of `--help` and `--version`; then there is nothing else to do
};

/// \throws Failure (usage)
Command_line parse_command_line(int argc, const char* const* argv);

}  // namespace conformal

#endif
