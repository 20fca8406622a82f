// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_FOLLOW_BRANCH_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_FOLLOW_BRANCH_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>
#include <Conformal_geometry_processing/spin/follow_branch.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE double overlap_of(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b)
{
  return norm(inner_product(a, b));
}

/// the point at t on the branch of `from`
CGP_INLINE Branch_point continued(const Dirac_gram& gram, const Branch_point& from, double t)
{
  Branch_point to{t, from.gamma + gram.quotient(t, from.c) - gram.quotient(from.t, from.c), from.c,
                  from.gap, from.least_gap};
  for (int k = 0; k < 4; ++k) {
    const auto ritz = hermitian_jacobi(gram.energy(t, to.gamma));
    Eigen::Index own = 0;
    for (Eigen::Index j = 1; j < ritz.values.size(); ++j)
      if (overlap_of(ritz.vectors.col(j), from.c) > overlap_of(ritz.vectors.col(own), from.c))
        own = j;
    to.c = ritz.vectors.col(own);
    const double before = to.gamma;
    to.gamma = gram.quotient(t, to.c);
    if (ritz.values.size() == 1) return to;
    to.gap = std::sqrt((std::max)(ritz.values[own == 0 ? 1 : 0], 0.));
    if (std::abs(to.gamma - before) <= 1e-3 * to.gap) break;
  }
  to.least_gap = (std::min)(from.least_gap, to.gap);
  return to;
}

CGP_INLINE Branch_point follow_branch(const Dirac_gram& gram, const Branch_point& first, double end,
                                      double least_overlap)
{
  const double longest = 1. / 4, shortest = 1. / 24, smooth = 0.95, same_branch = 0.75;
  Branch_point at = first;
  double step = longest;
  while (at.t < end) {
    const Branch_point next = continued(gram, at, (std::min)(end, at.t + step));
    const double turn = overlap_of(next.c, at.c), all = overlap_of(next.c, first.c);
    if ((turn < smooth || all < least_overlap) && step > shortest) {
      step = (std::max)(step / 2, shortest);
      continue;
    }
    if (turn < same_branch || all < least_overlap) return at;
    at = next;
    step = (std::min)(2 * step, longest);
  }
  return at;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
