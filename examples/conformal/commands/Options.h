// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_OPTIONS_H
#define CONFORMAL_COMMANDS_OPTIONS_H

#include "conformal/transform/Flatten_options.h"
#include "conformal/transform/Flow_options.h"
#include "conformal/transform/Spin_options.h"

#include <optional>
#include <string>

namespace conformal {

struct Info_options {
  std::string input;
};

struct Boundary_options {
  Spin_options spin;  ///< what this command has in common with that; without a source, rho is 0
  Prescription_options prescription;
  bool minimal = false;  ///< rho is -H
};

struct Fit_options {
  Spin_options spin;  ///< what this command has in common with that; input is the source
  std::string target;
  double blend = 0;   ///< 0 is conformal, 1 nearest to the target
  std::string scale;  ///< a formula of factors for the scales of the target, none if empty
  Boundary_choice boundary = Boundary_choice::tangents;  ///< taken from the target; not free
};

struct Blend_options {
  Spin_options spin;         ///< what this command has in common with that; input is A
  std::string other, onto;   ///< files; the difference is added to A, unless there is another
  double t = 0.5, from = 0;  ///< of B - A; the first of the frames
  int frames = 0;
};

struct Harmonic_options {
  std::string input;
  std::optional<int> form;  ///< the only one to be written
};

struct Compare_options {
  std::string before, after;
};

}  // namespace conformal

#endif
