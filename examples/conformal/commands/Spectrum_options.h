// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_SPECTRUM_OPTIONS_H
#define CONFORMAL_COMMANDS_SPECTRUM_OPTIONS_H

#include <optional>
#include <string>

namespace conformal {

/// what `conformal spectrum` takes
struct Spectrum_options {
  std::string input, csv;
  int count = 10;
  double shift = 0;
  double resolution = 0.005;  ///< eigenvalues nearer than this share of the largest are told as one
  std::optional<int> surface;  ///< the eigenfunction whose surface is written
};

/// what `conformal sphere` takes
struct Sphere_options {
  int kappa = -2, s = 0, level = 5;
};

}  // namespace conformal

#endif
