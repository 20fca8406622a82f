// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/flow/Bending_energy.h>
#include <Conformal_geometry_processing/flow/Fairing_patch.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgFlow
/// \brief K = L A^-1 L / 2 on the free vertices of a patch, for the vertices that bend: the second
/// derivative of the Willmore energy for a fixed metric, of each coordinate.
///
/// |free| x |free|, real symmetric, positive definite; joins vertices with a common neighbour.
class Bending_matrix {
 public:
  explicit Bending_matrix(const Fairing_patch& patch);

  const std::shared_ptr<const Sparse_pattern>& pattern() const { return m_pattern; }

  /// \brief Calls `add(k, x)` for the addends x of the value at each position k of the pattern.
  template <class Add>
  void assemble(const Bending_energy& energy, Add add) const
  {
    auto place = m_places.begin();
    for (std::size_t s = 0; s + 1 < m_offsets.size(); ++s) {
      const double inverse = .5 / energy.areas()[m_middles[s]];
      for (std::size_t p = m_offsets[s]; p < m_offsets[s + 1]; ++p)
        for (std::size_t q = m_offsets[s]; q <= p; ++q)
          add(*place++, inverse * coefficient(p, energy) * coefficient(q, energy));
    }
  }

 private:
  /// a free vertex in the row of L of a vertex that bends, and the edges to it: its one, or all of
  /// the middle
  struct Entry {
    int unknown;
    std::vector<int> edges;
  };

  double coefficient(std::size_t p, const Bending_energy& energy) const;
  void add_row(const Fairing_patch& patch, int v, const std::vector<int>& edges);
  void find_pattern(int size);

  // the rows of L of all vertices that bend, one after another
  std::vector<int> m_middles;
  std::vector<std::size_t> m_offsets{0};
  std::vector<Entry> m_entries;
  std::shared_ptr<const Sparse_pattern> m_pattern;
  std::vector<int> m_places;  // in the pattern, of the products of two entries of a row
};

}  // namespace Conformal_geometry_processing::internal
