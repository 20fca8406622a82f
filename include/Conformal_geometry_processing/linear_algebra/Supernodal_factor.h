// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SUPERNODAL_FACTOR_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/Aligned_array.h>
#include <Conformal_geometry_processing/linear_algebra/Extend_add.h>
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

  /// gives the memory of the numbers back; the next factorization allocates it anew
  void release()
  {
    m_panels.resize(0);
    for (auto& stack : m_stacks) stack.resize(0);
  }

  /// the panel of supernode s
  const Real* panel(int s) const { return m_panels.data() + m_panel_offsets[at(s)]; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static constexpr int lanes = Kernels::lanes, planes = Kernels::planes;

  int eliminate(int s, const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift,
                std::array<std::int64_t, 2>& top)
  {
    const Supernodal_structure& S = *m_structure;
    const int k = S.width(s), u = S.height(s);
    const std::size_t parity = at(S.depth(s) % 2);
    Real* const panel = m_panels.data() + m_panel_offsets[at(s)];
    std::fill_n(panel, Kernels::panel_size(k, u), Real(0));
    m_extend_add.set_front(k, u);
    add_matrix(s, A, shift, panel);
    for_each_child(s, top[1 - parity], [&](int c, const Real* update) {
      m_extend_add.add_to_panel(update, S.height(c), S.relative_rows(c), panel);
    });
    const int bad = Kernels::factor_panel(panel, k, Kernels::blocks(k) + Kernels::blocks(u));
    if (bad >= 0) return bad;

    Real* const own = m_stacks[parity].data() + top[parity];
    Kernels::set_outer_product(own, panel + Kernels::panel_size(k, 0), k, u);
    top[parity] += Kernels::update_size(u);
    top[1 - parity] = for_each_child(s, top[1 - parity], [&](int c, const Real* update) {
      m_extend_add.add_to_update(update, S.height(c), S.relative_rows(c), own);
    });
    return -1;
  }

  // Visits the updates of the children from the top of their stack; returns where the first begins.
  template <class Visitor>
  std::int64_t for_each_child(int s, std::int64_t top, Visitor visit)
  {
    const Supernodal_structure& S = *m_structure;
    const Real* const stack = m_stacks[at(1 - S.depth(s) % 2)].data();
    for (const int* c = S.children_end(s); c != S.children_begin(s);) {
      --c;
      top -= Kernels::update_size(S.height(*c));
      visit(*c, stack + top);
    }
    return top;
  }

  void add_matrix(int s, const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift,
                  Real* panel) const
  {
    const Supernodal_structure& S = *m_structure;
    for (const auto* e = S.entries_begin(s); e != S.entries_end(s); ++e) {
      FT c[planes];
      Scalar_planes<Scalar>::get(
          e->source >= 0 ? A.value(e->source) : conjugate(A.value(~e->source)), c);
      Real* const target = panel + m_extend_add.in_panel(e->row, e->column);
      for (int q = 0; q < planes; ++q) target[q * lanes] += static_cast<Real>(c[q]);
    }
    if (shift.size() == 0) return;
    for (int j = 0; j < S.width(s); ++j)
      panel[m_extend_add.in_panel(j, j)] += static_cast<Real>(shift[S.order()[at(S.first(s) + j)]]);
  }

  std::shared_ptr<const Supernodal_structure> m_structure;
  std::vector<std::int64_t> m_panel_offsets;  // size + 1
  std::array<std::int64_t, 2> m_stack_sizes;
  Aligned_array<Real> m_panels;
  std::array<Aligned_array<Real>, 2> m_stacks;
  Extend_add<Scalar, Real> m_extend_add;
};

}  // namespace Conformal_geometry_processing

#endif
