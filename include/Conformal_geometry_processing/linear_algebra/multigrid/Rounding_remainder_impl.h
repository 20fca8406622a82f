// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_ROUNDING_REMAINDER_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_ROUNDING_REMAINDER_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/Rounding_remainder.h>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE float to_single(double s)
{
  return static_cast<float>(s);
}

CGP_INLINE Quaternion<float> to_single(const Quaternion<double>& s)
{
  return {to_single(s.w), to_single(s.x), to_single(s.y), to_single(s.z)};
}

CGP_INLINE double to_double(float s)
{
  return static_cast<double>(s);
}

CGP_INLINE Quaternion<double> to_double(const Quaternion<float>& s)
{
  return {to_double(s.w), to_double(s.x), to_double(s.y), to_double(s.z)};
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
