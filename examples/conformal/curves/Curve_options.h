// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace conformal {

enum class Ends_choice { detect, closed, open };
enum class Closing_choice { exact, least_squares };

/// what `conformal curve` takes
struct Curve_options {
  std::string input;
  int steps = 10;
  double time_step = 0.5;
  Closing_choice closing = Closing_choice::exact;
  Ends_choice ends = Ends_choice::detect;
  int samples = 16;           ///< of each Bezier segment
  std::optional<int> pieces;  ///< no edge is longer than this part of its curve; undecided: in SVG
  int every = 0;              ///< steps from a picture to the next; none if zero
  bool animate = false;
  double seconds = 6;  ///< of the animation
};

}  // namespace conformal
