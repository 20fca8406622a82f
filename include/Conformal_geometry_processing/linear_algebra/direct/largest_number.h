// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/algebra/Quaternion.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Aligned_array.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace Conformal_geometry_processing::internal {

/// The largest of absolute values, in `sum_of_ranges()`; NaN is larger than all others
template <class FT>
struct Largest {
  FT value = 0;

  void add(FT number)
  {
    const FT size = std::abs(number);
    if (!(size <= value || std::isnan(value))) value = size;
  }

  Largest& operator+=(const Largest& other)
  {
    add(other.value);
    return *this;
  }
};

/// The largest absolute value of the numbers that the scalars at(i), 0 <= i < count, consist of
template <class Scalar, class At>
auto largest_of(std::ptrdiff_t count, const At& at)
{
  using FT = typename Scalar_traits<Scalar>::FT;
  constexpr int planes = Scalar_planes<Scalar>::size;
  constexpr std::ptrdiff_t at_once = 1 << 13;
  const auto add = [&](std::ptrdiff_t first, std::ptrdiff_t last, Largest<FT>& largest) {
    for (std::ptrdiff_t i = first; i < last; ++i) {
      FT c[planes];
      Scalar_planes<Scalar>::get(at(i), c);
      for (int q = 0; q < planes; ++q) largest.add(c[q]);
    }
  };
  return sum_of_ranges(count, at_once, Largest<FT>(), add).value;
}

template <class Scalar>
bool is_finite(const Hermitian_sparse_matrix<Scalar>& A)
{
  const auto value = [&A](std::ptrdiff_t k) { return A.value(static_cast<int>(k)); };
  return std::isfinite(largest_of<Scalar>(A.pattern().size_of_entries(), value));
}

/// The power of two just above the numbers of v, which may be too small, or too large, for another
/// type of numbers; 1 if a number is not finite
template <class Column>
auto power_of_two(const Column& v)
{
  using FT = typename Scalar_traits<typename Column::Scalar>::FT;
  const FT largest =
      largest_of<typename Column::Scalar>(v.size(), [&v](std::ptrdiff_t i) { return v[i]; });
  const bool is_usual = largest >= (std::numeric_limits<FT>::min)() && std::isfinite(largest);
  return is_usual ? std::ldexp(FT(1), (std::min)(std::ilogb(largest) + 1, 1000)) : FT(1);
}

template <class Real>
bool is_finite(const Aligned_array<Real>& numbers)
{
  const auto value = [&numbers](std::ptrdiff_t i) { return numbers.data()[i]; };
  return std::isfinite(largest_of<Real>(numbers.size(), value));
}

}  // namespace Conformal_geometry_processing::internal
