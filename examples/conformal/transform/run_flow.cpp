// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_flow.h"

#include "conformal/input/boundary_condition.h"

#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <cmath>

namespace conformal {
namespace {

CGP::Flow_options::Balance balance_of(Balance_choice choice)
{
  switch (choice) {
    case Balance_choice::initial:
      return CGP::Flow_options::Balance::initial;
    case Balance_choice::canonical:
      return CGP::Flow_options::Balance::canonical;
    case Balance_choice::none:
      break;
  }
  return CGP::Flow_options::Balance::none;
}

/// with --force there are none
CGP::Conformality::Limits limits_of(const Flow_options& options)
{
  if (options.force) return {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  return options.limits.map;
}

CGP::Flow_options options_of(const Flow_options& options, const Common_options& common)
{
  CGP::Flow_options flow;
  flow.max_steps = options.steps;
  flow.time_step = options.time_step;
  flow.filter_weight = options.filter_weight;
  flow.filter_order = options.filter_order;
  flow.balance = balance_of(options.balance);
  flow.boundary = kept_boundary(options.boundary);
  if (options.mollification.value_or(0) > 0) flow.mollification = options.mollification;
  flow.max_period_defect = options.max_period_defect;
  flow.exact_conformal_class = !options.plain;
  flow.scale_bound = options.scale_bound;
  flow.fairing = !options.no_fairing;
  flow.limits = limits_of(options);
  flow.dirac.tolerance = common.tolerance;
  flow.dirac.random_seed = common.seed;
  return flow;
}

}  // namespace

Flow_solution run_flow(const CGP::Mesh_view& mesh, const Flow_options& options,
                       const Common_options& common, Flow_watch& watch)
{
  CGP::Conformal_willmore_flow flow(mesh, options_of(options, common), {}, "flow");
  CGP::Flow_report report = flow.run(watch);
  return {flow.positions(), std::move(report)};
}

}  // namespace conformal
