// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "support/dense.h"

/// Eigenvectors are defined up to a quaternion on their right.
namespace cgp_test {

/// Returns the maximal difference of the components of a and b q, for the best unit quaternion q
inline double difference_up_to_right_quaternion(const Quaternion_vector<double>& a,
                                                const Quaternion_vector<double>& b)
{
  Quaternion<double> q{};
  for (Eigen::Index i = 0; i < a.size(); ++i) q += conjugate(b[i]) * a[i];
  q *= 1 / norm(q);
  Quaternion_vector<double> turned = b;
  for (Eigen::Index i = 0; i < b.size(); ++i) turned[i] = b[i] * q;
  return greatest_difference(a, turned);
}

}  // namespace cgp_test
