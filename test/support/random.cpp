// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/random.h"

namespace cgp_test {

Eigen::Matrix3d Random::rotation()
{
  const double angle = pi * number();
  return Eigen::AngleAxisd(angle, vector().normalized()).toRotationMatrix();
}

Eigen::VectorXd random_numbers(int n, std::uint64_t seed)
{
  Random random(seed);
  Eigen::VectorXd x(n);
  for (double& value : x) value = random.number();
  return x;
}

Quaternion_vector<double> random_quaternions(int n, std::uint64_t seed)
{
  Random random(seed);
  Quaternion_vector<double> q(n);
  for (int i = 0; i < n; ++i) q[i] = random.quaternion();
  return q;
}

std::vector<int> random_permutation(int n, std::uint64_t seed)
{
  Random random(seed);
  std::vector<int> order(at(n));
  std::iota(order.begin(), order.end(), 0);
  for (int i = n - 1; i > 0; --i) std::swap(order[at(i)], order[at(random.below(i + 1))]);
  return order;
}

Mesh_view perturbed(const Mesh_view& mesh, double amount, std::uint64_t seed)
{
  Random random(seed);
  return mapped(mesh, [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p + amount * random.vector());
  });
}

Mesh_view radially_perturbed(const Mesh_view& mesh, double amount, std::uint64_t seed)
{
  Random random(seed);
  return mapped(mesh, [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p * (1 + amount * random.number()));
  });
}

}  // namespace cgp_test
