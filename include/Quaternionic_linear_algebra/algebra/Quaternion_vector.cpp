// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <random>

namespace Conformal_geometry_processing {

Block<Quaternion<double>> random_quaternions(Eigen::Index rows, Eigen::Index columns, unsigned seed)
{
  std::mt19937 generator(seed);
  // Standard distributions differ between implementations, unlike the bits of the generator.
  const auto noise = [&] { return static_cast<double>(generator()) / 4294967296. - 0.5; };
  Block<Quaternion<double>> x(rows, columns);
  for (Eigen::Index c = 0; c < columns; ++c)
    for (Eigen::Index i = 0; i < rows; ++i) x(i, c) = {noise(), noise(), noise(), noise()};
  return x;
}

}  // namespace Conformal_geometry_processing
