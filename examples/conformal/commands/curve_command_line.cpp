// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "curve_command_line.h"

#include "option_groups.h"

namespace conformal {
namespace {

std::string between_zero_and_one(const std::string& text)
{
  return above_zero(text).empty() && std::stod(text) < 1 ? "" : "wanted a number between 0 and 1";
}

}  // namespace

void add_curve_options(CLI::App& command, Curve_options& curve)
{
  command.add_option("input", curve.input, "file with curves: SVG, CSV or OBJ")->required();
  command.add_option("--steps", curve.steps, "how many steps at most")
      ->check(above_zero)
      ->capture_default_str();
  command
      .add_option("--time-step", curve.time_step,
                  "what can be smoothed is multiplied by 1 - 2 T in a step: 0.5 goes furthest, "
                  "small ones show the way")
      ->check(between_zero_and_one)
      ->capture_default_str();
  add_choice(command, "--ends", curve.ends, {"detect", "closed", "open"},
             "whether the last point is followed by the first; detect: as the file says (Z, "
             "polygon, a last point that repeats the first), and in CSV where the gap is no longer "
             "than the longest edge");
  add_choice(command, "--closing", curve.closing, {"exact", "least-squares"},
             "how closed curves are kept closed: without stretching an edge, or by a little of it");
  command
      .add_option("--samples", curve.samples,
                  "points of each Bezier segment, and of a quarter of an ellipse")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command
      .add_option("--pieces", curve.pieces,
                  "divide long edges, which cannot bend, until none is longer than 1/PIECES of the "
                  "curve; 0 leaves all as they are; by default 200 for SVG, else 0")
      ->check(CLI::Range(0, 100000000));
  command
      .add_option("--every", curve.every,
                  "write every so many steps a snapshot, OUTPUT with the number of the step: "
                  "star_0005.svg; with --animate, the steps from one picture to the next")
      ->check(above_zero);
  command.add_flag("--animate", curve.animate,
                   "the output, an SVG file, shows the curves on their way, in a browser");
  command.add_option("--seconds", curve.seconds, "of the animation")
      ->check(above_zero)
      ->needs("--animate")
      ->capture_default_str();
}

}  // namespace conformal
