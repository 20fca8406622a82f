// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/torus_spectrum.h"
#include "support/decompositions.h"

namespace cgp_test {

Eigen::MatrixXd antiperiodic_derivative(int n)
{
  Eigen::MatrixXd d = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (double k = 0.5; k < n / 2; ++k)
        d(i, j) -= 2 * k * std::sin(2 * pi * k * (i - j) / n) / n;
  return d;
}

std::vector<double> torus_spectrum(double R, double r, double most)
{
  const int n = 64;
  const Eigen::MatrixXd derivative = antiperiodic_derivative(n) / r;
  Eigen::VectorXd distance(n), H(n);
  for (int i = 0; i < n; ++i) {
    const double c = std::cos(2 * pi * i / n);
    distance[i] = R + r * c;
    H[i] = (1 / r + c / distance[i]) / 2;
  }
  std::vector<double> all;
  for (double k = 0.5; k / (R + r) < most + 1 / r; ++k) {
    const Eigen::MatrixXd turn = (k / distance.array()).matrix().asDiagonal();
    Eigen::MatrixXd A(2 * n, 2 * n);
    A << Eigen::MatrixXd((-H).asDiagonal()), turn - derivative, turn + derivative,
        Eigen::MatrixXd((-H).asDiagonal());
    for (const double g : symmetric_eigenvalues(A))
      if (std::abs(g) < most) all.push_back(g);
  }
  std::sort(all.begin(), all.end());
  return all;
}

Mesh_view jittered_torus(double R, double r, int m, int n, double amount)
{
  const Mesh_view mesh = perturbed(torus(R, r, m, n), amount * 2 * pi * r / n);
  return mapped(mesh, [R, r](const Eigen::Vector3d& p) {
    const Eigen::Vector3d axis = R * Eigen::Vector3d(p.x(), p.y(), 0).normalized();
    return Eigen::Vector3d(axis + r * (p - axis).normalized());
  });
}

}  // namespace cgp_test
