// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/Aligned_array.h>
#include <Conformal_geometry_processing/linear_algebra/Front_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/Supernodal_structure.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the numbers of a supernodal Cholesky factor L L^H, found by the multifrontal method.
///
/// Fronts are eliminated in postorder; the update that a front leaves to its parent waits on one of
/// two stacks, which fronts of even and of odd depth share, so that a front can be pushed before
/// the updates of its children are popped. Panels and stacks are allocated once and used again.
///
/// \tparam Scalar a real, complex or quaternion type \tparam Real the numbers stored
template <class Scalar, class Real>
class Supernodal_factor {
 public:
  using Kernels = Front_kernels<Scalar, Real>;
  using FT = typename Scalar_traits<Scalar>::FT;

  explicit Supernodal_factor(std::shared_ptr<const Supernodal_structure> structure)
      : m_structure(std::move(structure))
  {
    const Supernodal_structure& S = *m_structure;
    m_panel_offsets.assign(1, 0);
    std::array<std::int64_t, 2> used = {0, 0}, most = {0, 0};
    for (int s = 0; s < S.size(); ++s) {
      m_panel_offsets.push_back(m_panel_offsets.back() +
                                Kernels::panel_size(S.width(s), S.height(s)));
      const std::size_t parity = static_cast<std::size_t>(S.depth(s) % 2);
      used[parity] += Kernels::update_size(S.height(s));
      most[parity] = std::max(most[parity], used[parity]);
      for (const int* c = S.children_begin(s); c != S.children_end(s); ++c)
        used[1 - parity] -= Kernels::update_size(S.height(*c));
    }
    m_stack_sizes = most;
  }

  const Supernodal_structure& structure() const { return *m_structure; }

  /// bytes of the panels, and of the stacks as well
  std::int64_t panel_bytes() const { return m_panel_offsets.back() * std::int64_t(sizeof(Real)); }
  std::int64_t bytes() const
  {
    return panel_bytes() + (m_stack_sizes[0] + m_stack_sizes[1]) * std::int64_t(sizeof(Real));
  }

  /// \brief factors A + diag(shift).
  /// \returns the vertex whose pivot is not positive, -1 if all are
  /// \throw std::bad_alloc
  int factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    m_panels.resize(m_panel_offsets.back());
    for (std::size_t i = 0; i < 2; ++i) m_stacks[i].resize(m_stack_sizes[i]);
    std::array<std::int64_t, 2> top = {0, 0};
    for (int s = 0; s < m_structure->size(); ++s) {
      const int bad = eliminate(s, A, shift, top);
      if (bad >= 0) return m_structure->order()[at(m_structure->first(s) + bad)];
    }
    return -1;
  }

  /// the panel of supernode s
  const Real* panel(int s) const { return m_panels.data() + m_panel_offsets[at(s)]; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static constexpr int lanes = Kernels::lanes, cell = Kernels::cell, planes = Kernels::planes;

  int eliminate(int s, const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift,
                std::array<std::int64_t, 2>& top)
  {
    const Supernodal_structure& S = *m_structure;
    const int k = S.width(s), u = S.height(s);
    Real* const panel = m_panels.data() + m_panel_offsets[at(s)];
    std::fill_n(panel, Kernels::panel_size(k, u), Real(0));
    const std::size_t parity = at(S.depth(s) % 2);
    Real* const update = m_stacks[parity].data() + top[parity];
    top[parity] += Kernels::update_size(u);
    std::fill_n(update, Kernels::update_size(u), Real(0));
    locate_rows(k, u);
    add_matrix(s, A, shift, panel);
    for (const int* c = S.children_end(s); c != S.children_begin(s);) {  // the last is on top
      --c;
      top[1 - parity] -= Kernels::update_size(S.height(*c));
      add_update(*c, m_stacks[1 - parity].data() + top[1 - parity], k, u, panel, update);
    }
    const int bad = Kernels::factor_panel(panel, k, Kernels::blocks(k) + Kernels::blocks(u));
    if (bad < 0 && u > 0)
      Kernels::subtract_outer_product(
          update, panel + static_cast<std::int64_t>(Kernels::blocks(k)) * k * cell, k, u);
    return bad;
  }

  // The offset of each row of the front in the first column of the panel.
  void locate_rows(int k, int u)
  {
    m_rows.resize(at(k + u));
    for (int i = 0; i < k + u; ++i) {
      const int block = i < k ? i / lanes : Kernels::blocks(k) + (i - k) / lanes;
      m_rows[at(i)] = block * k * cell + (i < k ? i : i - k) % lanes;
    }
  }

  void add_matrix(int s, const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift,
                  Real* panel) const
  {
    const Supernodal_structure& S = *m_structure;
    for (const auto* e = S.entries_begin(s); e != S.entries_end(s); ++e) {
      FT c[planes];
      Scalar_planes<Scalar>::get(
          e->source >= 0 ? A.value(e->source) : conjugate(A.value(~e->source)), c);
      Real* const target = panel + m_rows[at(e->row)] + e->column * cell;
      for (int q = 0; q < planes; ++q) target[q * lanes] += static_cast<Real>(c[q]);
    }
    if (shift.size() == 0) return;
    for (int j = 0; j < S.width(s); ++j)
      panel[m_rows[at(j)] + j * cell] += static_cast<Real>(shift[S.order()[at(S.first(s) + j)]]);
  }

  // Extend-add: the update of a child into the panel and the update of its parent.
  void add_update(int child, const Real* from, int k, int u, Real* panel, Real* update) const
  {
    const Supernodal_structure& S = *m_structure;
    const int* const place = S.relative_rows(child);
    const int n = S.height(child), nb = Kernels::blocks(n), parent_blocks = Kernels::blocks(u);
    for (int j = 0; j < n; ++j) {
      const int column = place[j];
      for (int ib = j / lanes; ib < nb; ++ib) {
        const Real* const source = from + Kernels::tile(nb, ib, j / lanes) + (j % lanes) * cell;
        const int begin = std::max(j, ib * lanes), end = std::min(n, (ib + 1) * lanes);
        for (int i = begin; i < end; ++i) {
          Real* target;
          if (column < k) {
            target = panel + m_rows[at(place[i])] + column * cell;
          } else {
            const int row = place[i] - k;
            target = update + Kernels::tile(parent_blocks, row / lanes, (column - k) / lanes) +
                     ((column - k) % lanes) * cell + row % lanes;
          }
          for (int q = 0; q < planes; ++q) target[q * lanes] += source[q * lanes + i % lanes];
        }
      }
    }
  }

  std::shared_ptr<const Supernodal_structure> m_structure;
  std::vector<std::int64_t> m_panel_offsets;  // size + 1
  std::array<std::int64_t, 2> m_stack_sizes;
  Aligned_array<Real> m_panels;
  std::array<Aligned_array<Real>, 2> m_stacks;
  std::vector<int> m_rows;  // of the current front
};

}  // namespace Conformal_geometry_processing

#endif
