// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SIMD_LANES_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SIMD_LANES_H

namespace Conformal_geometry_processing {
namespace internal {

/// bytes of the widest vector register of the target, as its macros tell: a wider kernel would be
/// spilled to memory, several times slower than a narrow one
#if defined(__AVX512F__)
constexpr int simd_bytes = 64;
#elif defined(__AVX__)
constexpr int simd_bytes = 32;
#else
constexpr int simd_bytes = 16;  // SSE2, NEON
#endif

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief so many numbers side by side as one register holds; arithmetic acts on each.
template <class Real>
struct Simd_lanes {
  static constexpr int size = internal::simd_bytes / static_cast<int>(sizeof(Real));
  typedef Real Register __attribute__((vector_size(internal::simd_bytes)));

  // Memory is aligned to registers wherever these two are used.
  static Register load(const Real* p) { return *reinterpret_cast<const Aliasing*>(p); }
  static void store(Real* p, Register v) { *reinterpret_cast<Aliasing*>(p) = v; }

 private:
  typedef Real Aliasing __attribute__((vector_size(internal::simd_bytes), may_alias));
};

}  // namespace Conformal_geometry_processing

#endif
