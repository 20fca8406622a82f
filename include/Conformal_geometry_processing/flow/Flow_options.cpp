// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Flow_options.h>

#include <cmath>

namespace Conformal_geometry_processing {

const Flow_options& checked(const Flow_options& o, const std::string& function)
{
  const auto require = [&](bool is_good, const std::string& found, const char* wanted) {
    if (!is_good) throw Precondition_error(function, found + "; " + wanted);
  };
  require(o.time_step > 0 && std::isfinite(o.time_step) && o.min_time_step > 0,
          "time steps of " + std::to_string(o.time_step) + " and " +
              std::to_string(o.min_time_step) + " at least",
          "positive ones are needed");
  require(o.max_steps >= 0, std::to_string(o.max_steps) + " steps",
          "a number that is not negative is needed");
  require(o.filter_weight >= 0 && std::isfinite(o.filter_weight),
          "a filter weight of " + std::to_string(o.filter_weight),
          "zero or a positive number is needed");
  require(o.filter_order >= 0, "an order of " + std::to_string(o.filter_order),
          "0, 1, 2, ... are possible");
  const internal::Scale_control& scales = o.surface.scales;
  require(!scales.bound || (*scales.bound > 1 && std::isfinite(*scales.bound)),
          "a scale bound of " + std::to_string(scales.bound.value_or(0)),
          "a number above 1 is needed");
  require(scales.factors.size() == 0 && scales.weights.size() == 0, "sizes are wanted or locked",
          "a flow can keep a bound only");
  require(!o.reduced_volume || (*o.reduced_volume > 0 && *o.reduced_volume <= 1),
          "a reduced volume of " + std::to_string(o.reduced_volume.value_or(0)),
          "a number above 0 and up to 1, which is that of a round sphere, is needed");
  require(!o.reduced_volume ||
              (o.surface.exact_conformal_class && o.balance == Flow_options::Balance::none),
          "a reduced volume off the exact conformal class, or with balance", "neither can keep it");
  require(o.surface.boundary.kind != Boundary_condition::Kind::positions,
          "positions are prescribed at the boundary", "a flow can keep directions only");
  return o;
}

}  // namespace Conformal_geometry_processing
