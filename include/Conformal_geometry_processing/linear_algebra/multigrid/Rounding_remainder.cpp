// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/multigrid/Rounding_remainder.h>

namespace Conformal_geometry_processing::internal {

float to_single(double s)
{
  return static_cast<float>(s);
}

Quaternion<float> to_single(const Quaternion<double>& s)
{
  return {to_single(s.w), to_single(s.x), to_single(s.y), to_single(s.z)};
}

double to_double(float s)
{
  return static_cast<double>(s);
}

Quaternion<double> to_double(const Quaternion<float>& s)
{
  return {to_double(s.w), to_double(s.x), to_double(s.y), to_double(s.z)};
}

}  // namespace Conformal_geometry_processing::internal
