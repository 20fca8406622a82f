// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "flow_command_line.h"

#include "option_groups.h"

namespace conformal {

void add_flow_options(CLI::App& command, Flow_options& flow)
{
  command.add_option("--steps", flow.steps, "how many steps at most")
      ->check(above_zero)
      ->capture_default_str();
  command
      .add_option("--time-step", flow.time_step,
                  "the largest; 1 goes furthest, 2 is the limit of stability")
      ->check(above_zero)
      ->check(CLI::Range(0., 2.))
      ->capture_default_str();
  command
      .add_option("--filter-weight", flow.filter_weight,
                  "keeps the large features; detail finer than this to the power "
                  "1/(2 order), in radii of the sphere of the same area, is smoothed")
      ->check(above_zero);
  command.add_option("--filter-order", flow.filter_order, "sharpness of the filter, 0 to 3")
      ->check(CLI::Range(0, 3))
      ->needs("--filter-weight")
      ->capture_default_str();
  add_boundary(command, flow.boundary);
  add_mollification(command, flow.mollification);
  add_choice(command, "--balance", flow.balance, {"none", "initial", "canonical"},
             "undoes drift of closed surfaces by sphere inversions: towards the initial areas, "
             "or those of the canonical metric (genus > 0)");
  command
      .add_option("--every", flow.every,
                  "write every so many steps a snapshot, OUTPUT with the number of the step: "
                  "bear_0005.ply")
      ->check(above_zero);
}

}  // namespace conformal
