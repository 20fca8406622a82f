// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion.h>
#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <complex>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief Represents a scalar as a `width` x `width` matrix of entries that other libraries
/// support, which acts on vectors of `width` coordinates; numbers represent themselves.
template <class Scalar>
struct Number_embedding {
  using Entry = Scalar;
  static constexpr int width = 1;
  using Matrix = Eigen::Matrix<Entry, width, width>;

  /// Matrix of the left multiplication by s
  static Matrix block(const Scalar& s) { return Matrix::Constant(s); }
  /// Writes the `width` coordinates of s
  static void to_entries(const Scalar& s, Entry* entries) { *entries = s; }
  /// Converts coordinates to a scalar
  static Scalar from_entries(const Entry* entries) { return *entries; }
};

/// \ingroup PkgLinearAlgebra
/// \brief A `Number_embedding` with quaternions as complex 2 x 2 matrices; takes half the memory
/// and time of real 4 x 4 matrices.
template <class Scalar>
struct Complex_embedding : Number_embedding<Scalar> {};

template <class FT>
struct Complex_embedding<Quaternion<FT>> {
  using Entry = std::complex<FT>;
  static constexpr int width = 2;
  using Matrix = Eigen::Matrix<Entry, width, width>;

  static Matrix block(const Quaternion<FT>& q) { return complex_block(q); }
  static void to_entries(const Quaternion<FT>& q, Entry* entries)
  {
    Eigen::Map<Eigen::Matrix<Entry, width, 1>>{entries} = complex_coordinates(q);
  }
  static Quaternion<FT> from_entries(const Entry* entries)
  {
    return quaternion(entries[0], entries[1]);
  }
};

/// \ingroup PkgLinearAlgebra
/// \brief A `Number_embedding` with quaternions as real 4 x 4 matrices, for libraries that support
/// real numbers only.
template <class Scalar>
struct Real_embedding : Number_embedding<Scalar> {};

template <class FT>
struct Real_embedding<Quaternion<FT>> {
  using Entry = FT;
  static constexpr int width = 4;
  using Matrix = Eigen::Matrix<Entry, width, width>;

  static Matrix block(const Quaternion<FT>& q) { return real_block(q); }
  static void to_entries(const Quaternion<FT>& q, Entry* entries)
  {
    entries[0] = q.w;
    entries[1] = q.x;
    entries[2] = q.y;
    entries[3] = q.z;
  }
  static Quaternion<FT> from_entries(const Entry* entries)
  {
    return {entries[0], entries[1], entries[2], entries[3]};
  }
};

}  // namespace Conformal_geometry_processing::internal
