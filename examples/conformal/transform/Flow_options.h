// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Boundary_options.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <optional>
#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

enum class Balance_choice { none, initial, canonical };

struct Flow_options {
  std::string input;
  int steps = 10;
  double time_step = 1;  ///< the largest; 2 is the limit of stability
  std::optional<double> scale_bound;
  double filter_weight = 0;
  int filter_order = 1;
  Balance_choice balance = Balance_choice::none;
  Boundary_choice boundary = Boundary_choice::free;
  std::optional<double> mollification;      ///< share of the mean edge; none or 0: no triangulation
  std::optional<double> max_period_defect;  ///< in each step, as for `Spin_options`
  int every = 0;                            ///< steps from a snapshot to the next; none if zero
  bool plain = false;                       ///< as in the thesis: off the exact class, no fairing
  bool no_fairing = false;
  bool force = false;
  CGP::Spin_report::Limits limits;
};

}  // namespace conformal
