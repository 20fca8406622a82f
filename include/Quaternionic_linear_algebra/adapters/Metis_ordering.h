// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <metis.h>

#include <cstddef>
#include <new>
#include <numeric>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \throws std::bad_alloc, Solver_error if the status is not METIS_OK
inline void check_metis_status(int status)
{
  if (status == METIS_ERROR_MEMORY) throw std::bad_alloc();
  if (status != METIS_OK)
    throw Solver_error("metis_ordering",
                       "METIS_NodeND failed with status " + std::to_string(status));
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes an ordering by multilevel nested dissection (Karypis and Kumar 1998) with METIS.
///
/// Needs no positions. Yields the least fill on convoluted meshes, but takes three to five times as
/// long as `sweep_nested_dissection()`, and as long as the factorization of a quaternionic matrix
/// on meshes of 100000 faces; use it for matrices that are factored often. Deterministic. METIS
/// reseeds and uses `std::rand()`: this affects the random numbers of the calling program, and
/// other threads must not use `std::rand()` meanwhile. This is the only header that includes METIS.
/// \throws Solver_error if METIS fails
inline internal::Ordering metis_ordering(const Sparse_pattern& pattern)
{
  static_assert(sizeof(idx_t) == sizeof(int), "METIS must be built with 32-bit indices");
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  idx_t n = pattern.size();
  if (pattern.size_of_entries() == n) {  // METIS does not accept graphs without edges
    internal::Ordering order(at(n));
    std::iota(order.begin(), order.end(), 0);
    return order;
  }
  std::vector<idx_t> offsets(at(n) + 1, 0);
  const auto visit = [&](auto action) {
    for (int j = 0; j < n; ++j)
      for (int k = pattern.offsets[at(j)] + 1; k < pattern.offsets[at(j) + 1]; ++k) {
        action(j, pattern.indices[at(k)]);
        action(pattern.indices[at(k)], j);
      }
  };
  visit([&](int i, int) { ++offsets[at(i) + 1]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<idx_t> neighbours(at(offsets.back())), next(offsets.begin(), offsets.end() - 1);
  visit([&](int i, int j) { neighbours[at(next[at(i)]++)] = j; });

  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;      // seeds std::rand() at the beginning of every call
  options[METIS_OPTION_COMPRESS] = 0;  // no two vertices of a mesh have the same neighbours
  internal::Ordering order(at(n)), inverse(at(n));
  internal::check_metis_status(METIS_NodeND(&n, offsets.data(), neighbours.data(), nullptr, options,
                                            order.data(), inverse.data()));
  return order;
}

}  // namespace Conformal_geometry_processing
