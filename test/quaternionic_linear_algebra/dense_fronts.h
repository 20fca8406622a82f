// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/vector_units/Vector_unit.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <vector>

#include "quaternionic_linear_algebra/every_unit.h"
#include "quaternionic_linear_algebra/hermitian_matrices.h"

/// Panels and updates of fronts as dense matrices, read and written by their documented layouts.
namespace cgp_test {

/// a scalar, and the numbers in which its factor is stored
template <class Scalar_, class Real_>
struct Kind {
  using Scalar = Scalar_;
  using Real = Real_;
  static constexpr int planes = CGP::internal::Scalar_planes<Scalar>::size;
  static constexpr double precision = sizeof(Real) == 4 ? 2e-5 : 1e-12;

  /// of the vector unit in use
  static CGP::internal::Front_kernels<Real> kernels() { return CGP::kernels_for<Real>(planes); }
  static CGP::internal::Panel_layout layout() { return kernels().layout; }
};
using Kinds = testing::Types<Kind<double, double>, Kind<double, float>,
                             Kind<std::complex<double>, double>, Kind<std::complex<double>, float>,
                             Kind<Quaternion<double>, double>, Kind<Quaternion<double>, float>>;

template <class Kind>
CGP::Block<typename Kind::Scalar> random_definite_block(int n, std::uint64_t seed)
{
  using Scalar = typename Kind::Scalar;
  auto A = random_block<Scalar>(n, n, seed);
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < j; ++i) A(i, j) = CGP::conjugate(A(j, i));
    A(j, j) = CGP::internal::Scalar_traits<Scalar>::from_real(2.5 * n + j % 7);
  }
  return A;
}

/// where the panel holds (row, column), rows of the triangle first; component 0
template <class Kind>
std::size_t in_panel(int columns, int row, int column)
{
  const int lanes = Kind::layout().lanes(), cell = Kind::planes * lanes;
  const int block =
      row < columns ? row / lanes : (columns + lanes - 1) / lanes + (row - columns) / lanes;
  const int lane = (row < columns ? row : row - columns) % lanes;
  return at((block * columns + column) * cell + lane);
}

/// where the update holds (row, column): block columns of square tiles
template <class Kind>
std::size_t in_update(int rows, int row, int column)
{
  const int lanes = Kind::layout().lanes(), cell = Kind::planes * lanes;
  const int blocks = (rows + lanes - 1) / lanes;
  int tile = row / lanes - column / lanes;
  for (int b = 0; b < column / lanes; ++b) tile += blocks - b;
  return at(tile * lanes * cell + column % lanes * cell + row % lanes);
}

template <class Kind>
void put(const typename Kind::Scalar& value, typename Kind::Real* to)
{
  double parts[Kind::planes];
  CGP::internal::Scalar_planes<typename Kind::Scalar>::get(value, parts);
  for (int q = 0; q < Kind::planes; ++q)
    to[q * Kind::layout().lanes()] = static_cast<typename Kind::Real>(parts[q]);
}

template <class Kind>
typename Kind::Scalar get(const typename Kind::Real* from)
{
  double parts[Kind::planes];
  for (int q = 0; q < Kind::planes; ++q) parts[q] = from[q * Kind::layout().lanes()];
  return CGP::internal::Scalar_planes<typename Kind::Scalar>::put(parts);
}

}  // namespace cgp_test
