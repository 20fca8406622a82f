// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Boundary_options.h"
#include "conformal/input/Rho_options.h"

#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <optional>
#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Control of scale: at most one of each pair of sources is not empty
struct Scale_options {
  /// on factors of lengths; none: rho is applied as it is
  std::optional<double> bound = CGP::internal::default_scale_bound;
  std::string target_expression, target_property;  ///< wanted factors
  std::string lock_expression, lock_property;      ///< positive where sizes have to stay
};

struct Spin_options {
  std::string input;
  Rho_options rho;
  Boundary_choice boundary = Boundary_choice::free;
  std::string lambda;  ///< the name of the vertex properties, none if empty
  CGP::Dirac_options::Eigenproblem problem = CGP::Dirac_options::Eigenproblem::standard;
  bool force = false;
  std::optional<double> mollification;  ///< share of the mean edge; 0: never, none: where it helps
  bool open_handles = false;  ///< rho is applied as it is, though it opens handles and holes
  std::optional<double> max_period_defect;  ///< of handles and holes; none: by the edge length
  Scale_options scales;
  bool exact_class = false;       ///< length cross-ratios are kept to rounding
  std::string solver = "native";  // or cholmod, eigen
  CGP::Spin_report::Limits limits;
};

}  // namespace conformal
