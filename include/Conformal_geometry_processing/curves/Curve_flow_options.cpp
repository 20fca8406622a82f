// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Curve_flow_options.h>

#include <string>

namespace Conformal_geometry_processing {

const Curve_flow_options& checked(const Curve_flow_options& o, const std::string& function)
{
  if (!(o.time_step > 0 && o.time_step < 1))
    throw Precondition_error(function, "a time step of " + std::to_string(o.time_step) +
                                           "; one between 0 and 1 is needed, where it is stable");
  if (o.max_steps < 0)
    throw Precondition_error(
        function, std::to_string(o.max_steps) + " steps; a number that is not negative is needed");
  if (!(o.energy_tolerance >= 0))
    throw Precondition_error(function, "a tolerance of " + std::to_string(o.energy_tolerance) +
                                           "; zero or a positive number is needed");
  return o;
}

}  // namespace Conformal_geometry_processing
