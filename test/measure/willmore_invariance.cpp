// Tests include/Conformal_geometry_processing/measure/energies.h, algebra/Moebius_map.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/energies.h>
#include <Quaternionic_linear_algebra/algebra/Moebius_map.h>

#include <gtest/gtest.h>

#include "support/moebius.h"
#include "support/tori.h"

namespace cgp_test::willmore_invariance_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Willmore_invariance, is_kept_by_inversions_up_to_second_order)
{
  // The centres of the specification's magnitude: the torus is not thrown to infinity.
  for (const Eigen::Vector3d& c : {Eigen::Vector3d(.1, .05, 0), Eigen::Vector3d(.2, -.1, .1)}) {
    const auto map = CGP::Moebius_map::sphere_inversion(c);
    std::vector<double> h, changes;
    for (int n : {24, 48, 96}) {
      const Mesh_view before = torus(std::sqrt(2.), 1, n, n);
      const Mesh_view after(map.transform(before.positions()), before.corners());
      h.push_back(1. / n);
      changes.push_back(CGP::willmore_energy(after) - CGP::willmore_energy(before));
    }
    EXPECT_NEAR(slope(h, changes), 2, 0.2);
    EXPECT_LT(std::abs(changes.back()), 2e-3 * 2 * pi * pi);
  }
}

TEST(Willmore_invariance, is_kept_by_an_inversion_from_within)
{
  std::vector<double> h, errors;
  for (int n : {48, 96, 192}) {
    const Mesh_view after = inverted(torus(std::sqrt(2.), 1, n, n), {std::sqrt(2.), 0, 0});
    h.push_back(1. / n);
    errors.push_back(std::abs(CGP::willmore_energy(with_reversed_faces(after))) / (2 * pi * pi) -
                     1);
  }
  EXPECT_NEAR(slope(h, errors), 2, 0.3);
}

}  // namespace cgp_test::willmore_invariance_tests
