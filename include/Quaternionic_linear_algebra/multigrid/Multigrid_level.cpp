// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/multigrid/Multigrid_level.h>

#include <cstdint>
#include <utility>

namespace Conformal_geometry_processing {

template <class Entry>
internal::Multigrid_level<Entry>::Multigrid_level(Matrix A, internal::Prolongation P)
    : m_matrix(std::move(A)), m_prolongation(std::move(P))
{
  m_vectors.resize(std::int64_t(stride) * size());
}

template <class Entry>
void internal::Multigrid_level<Entry>::smooth_first()
{
  for (int j = size() - 1; j >= 0; --j) {
    Register x;
    Lanes::load(vector(j), x);
    internal::Conjugate_sum<Entry> sum;
    const int diagonal = begin(j), end = begin(j + 1);
    for (int k = diagonal + 1; k < end; ++k) {
      Register xi;
      Lanes::load(vector(row(k)), xi);
      sum.add(m_matrix.value(k), xi);
    }
    sum.subtract_from(x);
    x /= internal::Scalar_traits<Entry>::real(m_matrix.value(diagonal));
    Lanes::store(vector(j), x);
    Lanes::store(residual(j), Register{});
    const internal::Scattered_product<Entry> product(x);
    for (int k = diagonal + 1; k < end; ++k) {
      Register ri;
      Lanes::load(residual(row(k)), ri);
      product.subtract(m_matrix.value(k), ri);
      Lanes::store(residual(row(k)), ri);
    }
  }
}

template <class Entry>
std::int64_t internal::Multigrid_level<Entry>::bytes() const
{
  const auto entries = static_cast<std::int64_t>(m_matrix.pattern().indices.size());
  return entries * std::int64_t(sizeof(Entry)) + std::int64_t(sizeof(float)) * m_vectors.size() +
         static_cast<std::int64_t>(m_prolongation.bytes());
}

// Computes (D + L)^-1 (D x - L^H e), with D x in `vector` and the correction e in `residual`.
template <class Entry>
void internal::Multigrid_level<Entry>::smooth_last()
{
  for (int j = 0; j < size(); ++j) {
    Register x;
    Lanes::load(vector(j), x);
    internal::Conjugate_sum<Entry> sum;
    const int diagonal = begin(j), end = begin(j + 1);
    for (int k = diagonal + 1; k < end; ++k) {
      Register ei;
      Lanes::load(residual(row(k)), ei);
      sum.add(m_matrix.value(k), ei);
    }
    sum.subtract_from(x);
    x /= internal::Scalar_traits<Entry>::real(m_matrix.value(diagonal));
    Lanes::store(vector(j), x);
    const internal::Scattered_product<Entry> product(x);
    for (int k = diagonal + 1; k < end; ++k) {
      Register xi;
      Lanes::load(vector(row(k)), xi);
      product.subtract(m_matrix.value(k), xi);
      Lanes::store(vector(row(k)), xi);
    }
  }
}

template class internal::Multigrid_level<float>;
template class internal::Multigrid_level<Quaternion<float>>;

}  // namespace Conformal_geometry_processing
