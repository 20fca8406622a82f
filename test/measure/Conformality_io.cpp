// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/measure/Conformality_io.h
#include <Conformal_geometry_processing/measure/Conformality_io.h>

#include <gtest/gtest.h>

#include <sstream>

namespace cgp_test::conformality_io_tests {

TEST(Conformality_io, prints_one_fact_per_line)
{
  Conformal_geometry_processing::Conformality c;
  c.quasi_conformal = {1.015625, 1.03125, 1.0625};
  c.length_cross_ratio = {0.002, 0.005};
  c.scale.min_scale = 0.5;
  c.scale.max_scale = 3;
  c.flipped_faces = 7;
  std::ostringstream out;
  Conformal_geometry_processing::internal::print_conformality(out, c);
  EXPECT_EQ(out.str(),
            "quasi-conformal error  1.01562 mean, 1.03125 for 99 %, 1.0625 at most (1 is "
            "conformal)\n"
            "length cross-ratios    changed by 0.002 rms, 0.005 at most (0 is conformal)\n"
            "lengths                scaled by 0.5 to 3\n"
            "flipped faces          7\n");
}

}  // namespace cgp_test::conformality_io_tests
