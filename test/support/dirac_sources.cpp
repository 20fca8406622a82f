// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/dirac_sources.h"

namespace cgp_test {

Quaternion_matrix sources(int rows, int columns)
{
  Quaternion_matrix c = zero_matrix(rows, columns);
  for (int j = 0; j < columns; ++j) {
    c.col(j) = random_quaternions(rows, static_cast<std::uint64_t>(j));
    Quaternion<double> sum{};
    for (int i = 1; i < rows; ++i) sum += c(i, j);
    c(0, j) = -sum;
  }
  return c;
}

void expect_solutions(const CGP::Surface_ref& surface, const Quaternion_matrix& Y,
                      const Quaternion_matrix& c)
{
  ASSERT_EQ(Y.cols(), c.cols());
  const auto X = CGP::dirac_energy(surface, CGP::no_potential(surface));
  const Eigen::VectorXd m = CGP::vertex_areas(surface);
  for (Eigen::Index j = 0; j < c.cols(); ++j) {
    EXPECT_LT(greatest_difference(X * Y.col(j), c.col(j)), 1e-8 * greatest_entry(c));
    Quaternion<double> sum{};
    for (Eigen::Index i = 0; i < m.size(); ++i) sum += m[i] * Y(i, j);
    EXPECT_LT(norm(sum), 1e-11 * m.sum() * greatest_entry(Y));
  }
}

}  // namespace cgp_test
