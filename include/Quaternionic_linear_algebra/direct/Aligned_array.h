// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace Conformal_geometry_processing::internal {

/// \brief An uninitialized array of numbers, aligned to cache lines. Memory is not touched before
/// its first use, and is reused.
template <class Real>
class Aligned_array {
 public:
  /// Keeps the memory if the size is the same; otherwise the values are lost
  /// \throw std::bad_alloc, with no memory held
  void resize(std::int64_t size)
  {
    if (size == m_size) return;
    m_data.reset();
    m_size = 0;
    if (size > 0) m_data = allocate(static_cast<std::size_t>(size) * sizeof(Real));
    m_size = size;
  }

  std::int64_t size() const { return m_size; }
  Real* data() { return m_data.get(); }
  const Real* data() const { return m_data.get(); }

 private:
  static constexpr std::align_val_t line{64}, page{std::size_t(1) << 21};

  struct Free {
    std::align_val_t alignment = line;
    void operator()(Real* p) const { ::operator delete(p, alignment); }
  };
  using Pointer = std::unique_ptr<Real, Free>;

  // The first access to a page costs as much as the arithmetic on it, so large arrays use huge
  // pages if the system supports them.
  static Pointer allocate(std::size_t bytes)
  {
    const bool is_large = bytes >= 2 * static_cast<std::size_t>(page);
    const std::align_val_t alignment = is_large ? page : line;
    Pointer data(static_cast<Real*>(::operator new(bytes, alignment)), Free{alignment});
#ifdef MADV_HUGEPAGE
    if (is_large) madvise(data.get(), bytes, MADV_HUGEPAGE);
#endif
    return data;
  }

  Pointer m_data;
  std::int64_t m_size = 0;
};

}  // namespace Conformal_geometry_processing::internal
