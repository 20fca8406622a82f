// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_ALIGNED_ARRAY_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_ALIGNED_ARRAY_H

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief numbers without initial values, aligned to cache lines: memory that is not touched before
/// it is used, and is kept.
template <class Real>
class Aligned_array {
 public:
  /// keeps the memory if the size is the same; the values are lost otherwise
  /// \throw std::bad_alloc, with no memory held
  void resize(std::int64_t size)
  {
    if (size == m_size) return;
    m_data.reset();
    m_size = 0;
    if (size > 0)
      m_data.reset(static_cast<Real*>(
          ::operator new(static_cast<std::size_t>(size) * sizeof(Real), alignment)));
    m_size = size;
  }

  std::int64_t size() const { return m_size; }
  Real* data() { return m_data.get(); }
  const Real* data() const { return m_data.get(); }

 private:
  static constexpr std::align_val_t alignment{64};
  struct Free {
    void operator()(Real* p) const { ::operator delete(p, alignment); }
  };

  std::unique_ptr<Real, Free> m_data;
  std::int64_t m_size = 0;
};

}  // namespace Conformal_geometry_processing

#endif
