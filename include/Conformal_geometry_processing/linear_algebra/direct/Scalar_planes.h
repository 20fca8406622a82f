// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SCALAR_PLANES_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SCALAR_PLANES_H

#include <Conformal_geometry_processing/algebra/scalar.h>

#include <complex>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Scalars as arrays of their real components, so that the same dense kernels work for real,
/// complex and quaternionic matrices (see `Plane_products`).
template <class Scalar>
struct Scalar_planes;

template <>
struct Scalar_planes<double> {
  static constexpr int size = 1;

  static void get(double s, double* c) { c[0] = s; }
  static double put(const double* c) { return c[0]; }
};

template <>
struct Scalar_planes<float> {
  static constexpr int size = 1;

  static void get(float s, float* c) { c[0] = s; }
  static float put(const float* c) { return c[0]; }
};

template <class FT>
struct Scalar_planes<std::complex<FT>> {
  static constexpr int size = 2;

  static void get(const std::complex<FT>& s, FT* c) { c[0] = s.real(), c[1] = s.imag(); }
  static std::complex<FT> put(const FT* c) { return {c[0], c[1]}; }
};

template <class FT>
struct Scalar_planes<Quaternion<FT>> {
  static constexpr int size = 4;

  static void get(const Quaternion<FT>& s, FT* c)
  {
    c[0] = s.w, c[1] = s.x, c[2] = s.y, c[3] = s.z;
  }
  static Quaternion<FT> put(const FT* c) { return {c[0], c[1], c[2], c[3]}; }
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#endif
