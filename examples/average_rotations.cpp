// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Finds the rotations of many cameras from noisy measurements of how each is turned against its
// neighbours: sparse linear algebra over the quaternions, without any surface.
//
//   average_rotations [CAMERAS [NOISE [ANGLES.txt]]]
//
// ANGLES.txt gets two angles a camera, in degrees: how far its rotation is from the truth, taken
// from one camera to the next, and by the eigenvector.
//
// Unit quaternions q_i with q_i = r_ij q_j make the sum of |q_i - r_ij q_j|^2 zero. Measured r_ij
// do not fit together; the smallest eigenvector of that sum's Hermitian matrix comes nearest.
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/direct_solvers.h>
#include <Quaternionic_linear_algebra/eigensolvers.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <utility>
#include <vector>

namespace CGP = Conformal_geometry_processing;
using Quaternion = CGP::Quaternion<double>;

// the angle between two rotations
double degrees(const Quaternion& p, const Quaternion& q)
{
  const double cosine = std::abs(CGP::dot(p, q)) / (CGP::norm(p) * CGP::norm(q));
  return 360 / 3.14159265358979 * std::acos((std::min)(cosine, 1.));
}

int main(int argc, char* argv[])
{
  const int n = argc > 1 ? std::atoi(argv[1]) : 2000;
  const double noise = argc > 2 ? std::atof(argv[2]) : .1;
  if (n < 3) return EXIT_FAILURE;
  CGP::Quaternion_vector<double> truth = CGP::random_quaternions(n, 1, 1);
  for (auto& q : truth) q = q / CGP::norm(q);
  const CGP::Block<Quaternion> errors = CGP::random_quaternions(n, 3, 2);

  //! [matrix]
  std::vector<std::vector<int>> seen(n);  // each camera sees the next three
  for (int j = 0; j < n; ++j)
    for (int i = j + 1; i < (std::min)(j + 4, n); ++i) seen[j].push_back(i);
  const auto pattern = CGP::sparse_pattern(std::move(seen));
  CGP::Hermitian_sparse_matrix<Quaternion> A(pattern);
  for (int j = 0; j < n; ++j)
    for (int i = j + 1; i < (std::min)(j + 4, n); ++i) {
      const Quaternion r = truth[i] * CGP::inverse(truth[j]) + noise * errors(j, i - j - 1);
      A.value(pattern->find(i, j)) = -(1 / CGP::norm(r)) * r;
      for (int k : {i, j}) A.value(pattern->find(k, k)) += Quaternion{1, 0, 0, 0};
    }
  //! [matrix]

  //! [eigenvector]
  CGP::Supernodal_cholesky<Quaternion> factor;
  const Eigen::VectorXd masses = Eigen::VectorXd::Ones(n);
  if (factor.analyze(*pattern) != CGP::Solver_status::success ||
      factor.factorize(A, 1e-6 * masses) != CGP::Solver_status::success)
    return EXIT_FAILURE;
  const CGP::Eigensolver_result found = CGP::Lobpcg_eigensolver_traits()(
      A, CGP::Vector<double>(masses), factor, CGP::random_quaternions(n, 1, 3));
  //! [eigenvector]

  Quaternion overlap{0, 0, 0, 0};  // all may be turned by one rotation, from the right
  for (int i = 0; i < n; ++i)
    overlap += CGP::conjugate(truth[i]) * found.vectors(i, 0) / CGP::norm(found.vectors(i, 0));
  std::ofstream angles(argc > 3 ? argv[3] : "");
  Quaternion next = truth[0];
  for (int i = 0; i < n; ++i) {
    const Quaternion found_i = found.vectors(i, 0) * CGP::inverse(overlap);
    angles << degrees(next, truth[i]) << ' ' << degrees(found_i, truth[i]) << '\n';
    if (i + 1 < n) next = -1 * (A.value(pattern->find(i + 1, i)) * next);
  }
  std::cout << n << " rotations in " << found.iterations << " iterations, overlap with the truth "
            << CGP::norm(overlap) / n << '\n';
  return found.converged ? EXIT_SUCCESS : EXIT_FAILURE;
}
