// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/direct/Aligned_array.h>
#include <Quaternionic_linear_algebra/multigrid/Prolongation.h>
#include <Quaternionic_linear_algebra/vector_units/Simd_lanes.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief The four numbers of a vector at one vertex: the components w, x, y, z of a quaternion, or
/// one number for each of four right-hand sides of a real system.
///
/// Both kinds of systems share the same loops. Registers are passed by reference, because without
/// AVX there is no calling convention for four doubles.
template <class Real>
struct Vertex_lanes {
  static constexpr int size = 4;
#ifdef CGP_HAS_VECTOR_EXTENSIONS
  typedef Real Register __attribute__((vector_size(4 * sizeof(Real))));
#else
  using Register = Lane_array<Vertex_lanes, Real, 4>;
#endif

  static CGP_ALWAYS_INLINE void load(const Real* p, Register& v)
  {
    v = *reinterpret_cast<const Aliasing*>(p);
  }
  static CGP_ALWAYS_INLINE void store(Real* p, const Register& v)
  {
    *reinterpret_cast<Aliasing*>(p) = v;
  }

  /// Replaces v by i v, j v and k v
  static CGP_ALWAYS_INLINE void multiply_by_i(Register& v)
  {
    exchange<1, 0, 3, 2>(Register{-1, 1, -1, 1}, v);
  }
  static CGP_ALWAYS_INLINE void multiply_by_j(Register& v)
  {
    exchange<2, 3, 0, 1>(Register{-1, 1, 1, -1}, v);
  }
  static CGP_ALWAYS_INLINE void multiply_by_k(Register& v)
  {
    exchange<3, 2, 1, 0>(Register{-1, -1, 1, 1}, v);
  }

 private:
#ifdef CGP_HAS_VECTOR_EXTENSIONS
  // A cache line holds whole vertices, but not every array begins at a cache line.
  typedef Real Aliasing
      __attribute__((vector_size(4 * sizeof(Real)), may_alias, aligned(sizeof(Real))));
  using Index = std::conditional_t<sizeof(Real) == 4, int, long long>;
  typedef Index Indices __attribute__((vector_size(4 * sizeof(Real))));
#else
  using Aliasing = Register;
#endif

  // Replaces v by its lanes a, b, c, d, times the signs
  template <int a, int b, int c, int d>
  static CGP_ALWAYS_INLINE void exchange(const Register& signs, Register& v)
  {
#if !defined(CGP_HAS_VECTOR_EXTENSIONS)
    v = signs * Register{{v[a], v[b], v[c], v[d]}};
#elif defined(__clang__)
    v = signs * __builtin_shufflevector(v, v, a, b, c, d);
#else
    v = signs * __builtin_shuffle(v, Indices{a, b, c, d});
#endif
  }
};

/// \ingroup PkgLinearAlgebra
/// \brief The sum of conjugate(a) x over some entries a of a column; `value()` returns it.
///
/// A quaternionic sum is accumulated separately for each component of a, so that components are
/// permuted once per column instead of once per entry.
template <class Entry>
class Conjugate_sum {
  using Lanes = Vertex_lanes<Entry>;

 public:
  CGP_ALWAYS_INLINE void add(Entry a, const typename Lanes::Register& x) { m_sum += a * x; }
  CGP_ALWAYS_INLINE void subtract_from(typename Lanes::Register& y) const { y -= m_sum; }

 private:
  typename Lanes::Register m_sum = {};
};

template <class Real>
class Conjugate_sum<Quaternion<Real>> {
  using Lanes = Vertex_lanes<Real>;

 public:
  CGP_ALWAYS_INLINE void add(const Quaternion<Real>& a, const typename Lanes::Register& x)
  {
    m_w += a.w * x, m_x += a.x * x, m_y += a.y * x, m_z += a.z * x;
  }
  CGP_ALWAYS_INLINE void subtract_from(typename Lanes::Register& y) const
  {
    typename Lanes::Register i = m_x, j = m_y, k = m_z;
    Lanes::multiply_by_i(i), Lanes::multiply_by_j(j), Lanes::multiply_by_k(k);
    y += (i + j) + (k - m_w);
  }

 private:
  typename Lanes::Register m_w = {}, m_x = {}, m_y = {}, m_z = {};
};

/// \ingroup PkgLinearAlgebra
/// \brief y -= a x for one x and many entries a, y.
template <class Entry>
class Scattered_product {
  using Lanes = Vertex_lanes<Entry>;

 public:
  explicit CGP_ALWAYS_INLINE Scattered_product(const typename Lanes::Register& x) : m_x(x) {}
  CGP_ALWAYS_INLINE void subtract(Entry a, typename Lanes::Register& y) const { y -= a * m_x; }

 private:
  typename Lanes::Register m_x;
};

template <class Real>
class Scattered_product<Quaternion<Real>> {
  using Lanes = Vertex_lanes<Real>;

 public:
  explicit CGP_ALWAYS_INLINE Scattered_product(const typename Lanes::Register& x)
      : m_x(x), m_ix(x), m_jx(x), m_kx(x)
  {
    Lanes::multiply_by_i(m_ix), Lanes::multiply_by_j(m_jx), Lanes::multiply_by_k(m_kx);
  }
  CGP_ALWAYS_INLINE void subtract(const Quaternion<Real>& a, typename Lanes::Register& y) const
  {
    y -= a.w * m_x, y -= a.x * m_ix, y -= a.y * m_jx, y -= a.z * m_kx;
  }

 private:
  typename Lanes::Register m_x, m_ix, m_jx, m_kx;
};

/// \ingroup PkgLinearAlgebra
/// \brief One level of a multigrid hierarchy: a matrix A, the prolongation from the next coarser
/// level, and Gauss-Seidel smoothing before and after the coarse-grid correction.
///
/// The two sweeps run in opposite directions, so that for every Hermitian positive definite coarse
/// correction the cycle is Hermitian, and positive definite as long as the diagonal of A is
/// positive (even if rounding has made A indefinite). Only the lower triangle is stored; each sweep
/// traverses it once and uses every entry for its conjugate transpose as well.
///
/// Vectors have four numbers per vertex (`Vertex_lanes`).
/// \tparam Entry `float` or `Quaternion<float>`
template <class Entry>
class Multigrid_level {
 public:
  using Matrix = Hermitian_sparse_matrix<Entry>;

  /// \pre the diagonal of A is positive
  Multigrid_level(Matrix A, Prolongation P);

  int size() const { return m_matrix.size(); }
  const Matrix& matrix() const { return m_matrix; }
  const Prolongation& prolongation() const { return m_prolongation; }

  /// The four numbers of vertex i: the right-hand side before the cycle, the solution after it
  float* vector(int i) { return m_vectors.data() + std::ptrdiff_t(stride) * i; }
  const float* vector(int i) const { return m_vectors.data() + std::ptrdiff_t(stride) * i; }

  /// Computes x = (D + L^H)^-1 b, which overwrites b, and the residual r = b - A x = -L x; L is the
  /// strictly lower triangle
  void smooth_first();

  /// Calls visit(I, c) with contributions c to the four numbers of (P^T r)_I, which are to be added
  template <class Visitor>
  void restrict_residual(Visitor visit)
  {
    for (int i = 0; i < size(); ++i) {
      Register r;
      Lanes::load(residual(i), r);
      m_prolongation.for_each_in_row(i,
                                     [&](int I, float weight) { visit(I, Register(weight * r)); });
    }
  }

  /// \brief Adds the coarse-grid correction, x + P c, where c(I) points to its four numbers at I,
  /// and smooths by the adjoint sweep: x := (D + L)^-1 (b - L^H (x + P c)) = (D + L)^-1 (D x - L^H
  /// P c).
  template <class Correction>
  void correct_and_smooth(Correction c)
  {
    for (int i = 0; i < size(); ++i) {
      Register x, e = {};
      Lanes::load(vector(i), x);
      m_prolongation.for_each_in_row(i, [&](int I, float weight) {
        Register ci;
        Lanes::load(c(I), ci);
        e += weight * ci;
      });
      x *= m_matrix.diagonal(i);
      Lanes::store(vector(i), x);
      Lanes::store(residual(i), e);
    }
    smooth_last();
  }

  std::int64_t bytes() const;

 private:
  using Lanes = Vertex_lanes<float>;
  using Register = Lanes::Register;
  static constexpr int stride = 8;  // vector and residual are adjacent, to be loaded together

  int begin(int j) const { return m_matrix.pattern().offsets[static_cast<std::size_t>(j)]; }
  int row(int k) const { return m_matrix.pattern().indices[static_cast<std::size_t>(k)]; }
  float* residual(int i) { return vector(i) + 4; }

  void smooth_last();

  Matrix m_matrix;
  Prolongation m_prolongation;
  Aligned_array<float> m_vectors;  // 4 + 4 numbers per vertex
};

}  // namespace Conformal_geometry_processing::internal
