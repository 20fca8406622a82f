// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "support/mesh_tools.h"

/// Random input that is the same on every machine: distributions of <random> are not.
namespace cgp_test {

using Conformal_geometry_processing::Quaternion;
using Conformal_geometry_processing::Quaternion_vector;

class Random {
 public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}

  /// in [-1, 1)
  double number() { return std::ldexp(static_cast<double>(m_engine() >> 11), -52) - 1; }

  /// in [0, n)
  int below(int n) { return static_cast<int>(m_engine() % static_cast<std::uint64_t>(n)); }

  Eigen::Vector3d vector()
  {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

  Quaternion<double> quaternion()
  {
    const double w = number(), x = number(), y = number(), z = number();
    return {w, x, y, z};
  }

  /// a rotation of R^3
  Eigen::Matrix3d rotation();

 private:
  std::mt19937_64 m_engine;  // its sequence is fixed by the standard
};

/// n numbers in [-1, 1)
Eigen::VectorXd random_numbers(int n, std::uint64_t seed);

/// n quaternions with components in [-1, 1)
Quaternion_vector<double> random_quaternions(int n, std::uint64_t seed);

/// a permutation of 0..n-1
std::vector<int> random_permutation(int n, std::uint64_t seed);

/// every coordinate of every vertex moves by up to `amount`
Mesh_view perturbed(const Mesh_view& mesh, double amount, std::uint64_t seed = 1);

/// every vertex of a surface around the origin moves to or from it by up to the share `amount`
Mesh_view radially_perturbed(const Mesh_view& mesh, double amount, std::uint64_t seed = 1);

}  // namespace cgp_test
