// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_SCALAR_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_SCALAR_H

#include <Conformal_geometry_processing/algebra/Quaternion.h>

#include <complex>
#include <type_traits>

namespace Conformal_geometry_processing {

/// The conjugate of a real number, for templates over scalars
template <class FT, class = std::enable_if_t<std::is_floating_point_v<FT>>>
constexpr FT conjugate(FT s)
{
  return s;
}

/// The complex conjugate
template <class FT>
std::complex<FT> conjugate(const std::complex<FT>& s)
{
  return std::conj(s);
}

namespace internal {

/// \ingroup PkgAlgebra
/// Properties of a scalar type: the type of its real components, and the real part
template <class Scalar>
struct Scalar_traits {
  using FT = Scalar;
  static constexpr FT real(const Scalar& s) { return s; }
  static constexpr Scalar from_real(FT s) { return s; }
};

template <class FT_>
struct Scalar_traits<std::complex<FT_>> {
  using FT = FT_;
  static constexpr FT real(const std::complex<FT>& s) { return s.real(); }
  static constexpr std::complex<FT> from_real(FT s) { return s; }
};

template <class FT_>
struct Scalar_traits<Quaternion<FT_>> {
  using FT = FT_;
  static constexpr FT real(const Quaternion<FT>& s) { return s.w; }
  static constexpr Quaternion<FT> from_real(FT s) { return {s, 0, 0, 0}; }
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#endif
