// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>

#include <cmath>
#include <type_traits>

namespace Conformal_geometry_processing::internal {

float to_single(double s);
Quaternion<float> to_single(const Quaternion<double>& s);
double to_double(float s);
Quaternion<double> to_double(const Quaternion<float>& s);

/// \ingroup PkgLinearAlgebra
/// \brief The remainder of a matrix after rounding to single precision.
///
/// The rounded matrix is used by preconditioners; its sum with the remainder, also in single
/// precision, represents the matrix to 14 digits. Both take half of the memory that a copy in
/// double precision beside the rounded matrix would take.
///
/// \tparam Scalar `double` or `Quaternion<double>`
template <class Scalar>
class Rounding_remainder {
 public:
  using FT = typename Scalar_traits<Scalar>::FT;
  using Entry = std::conditional_t<std::is_same_v<Scalar, double>, float, Quaternion<float>>;
  using Rounded = Hermitian_sparse_matrix<Entry>;

  /// \brief Returns A + diag(shift), rounded, on the shared pattern of A; stores the remainder.
  /// \param shift one number per row, or empty
  Rounded split(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    Rounded rounded(A.shared_pattern());
    m_values.resize(A.pattern().size_of_entries());
    m_is_finite = true;
    const int* const offsets = A.pattern().offsets.data();
    for (int j = 0; j < A.size(); ++j)
      for (int k = offsets[j]; k < offsets[j + 1]; ++k) {
        Scalar a = A.value(k);
        if (k == offsets[j] && shift.size() > 0) a += Scalar_traits<Scalar>::from_real(shift[j]);
        rounded.value(k) = internal::to_single(a);
        const Scalar rest = a - internal::to_double(rounded.value(k));
        m_values[k] = internal::to_single(rest);
        m_is_finite = m_is_finite && std::isfinite(sum_of_components(rest));
      }
    return rounded;
  }

  /// Returns whether all values of the last matrix, and their roundings, were finite
  bool is_finite() const { return m_is_finite; }

  /// Computes y = A x in the memory of y, where `rounded` was returned by `split(A)`
  void multiply(const Rounded& rounded, const Block<Scalar>& x, Block<Scalar>& y) const
  {
    y.resize(x.rows(), x.cols());
    const int* const offsets = rounded.pattern().offsets.data();
    const int* const rows = rounded.pattern().indices.data();
    // Backward, so that y_i is assigned before the columns left of i add to it.
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      for (int j = rounded.size() - 1; j >= 0; --j) {
        Scalar sum = value(rounded, offsets[j]) * x(j, c);
        for (int k = offsets[j] + 1; k < offsets[j + 1]; ++k) {
          const Scalar a = value(rounded, k);
          sum += conjugate(a) * x(rows[k], c);
          y(rows[k], c) += a * x(j, c);
        }
        y(j, c) = sum;
      }
  }

  double bytes() const { return static_cast<double>(sizeof(Entry)) * double(m_values.size()); }

  /// Releases the memory
  void release() { m_values.resize(0); }

 private:
  static double sum_of_components(double s) { return s; }
  static double sum_of_components(const Quaternion<double>& s) { return s.w + s.x + s.y + s.z; }

  Scalar value(const Rounded& rounded, int k) const
  {
    return internal::to_double(rounded.value(k)) + internal::to_double(m_values[k]);
  }

  Vector<Entry> m_values;  // parallel to those of the rounded matrix
  bool m_is_finite = true;
};

}  // namespace Conformal_geometry_processing::internal
