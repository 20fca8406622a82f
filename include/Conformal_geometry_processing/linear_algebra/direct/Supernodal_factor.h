// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Aligned_array.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Elimination_tasks.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_instances.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/Front_kernels.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief The numerical part of a supernodal Cholesky factor L L^H, computed by the multifrontal
/// method.
///
/// Fronts are eliminated children before parents; the update matrix that a front passes to its
/// parent is stored in an array (`Contribution_stack`). Subtrees are tasks for several threads, and
/// the large fronts above them are divided by rows. The partition depends on the structure only,
/// and each number is computed by the same operations in the same order on any thread, so the
/// factor is bitwise the same for any number of threads. Memory is allocated once and reused.
///
/// The dense operations use the kernels of the `vector_unit()` at construction, which also
/// determine the layout of the numbers.
///
/// \tparam Scalar a real, complex or quaternion type \tparam Real the numbers stored. The compiled
/// library contains the combinations listed in Supernodal_instances.h.
template <class Scalar, class Real>
class Supernodal_factor {
 public:
  using FT = typename Scalar_traits<Scalar>::FT;

  explicit Supernodal_factor(std::shared_ptr<const Supernodal_structure> structure);

  const Supernodal_structure& structure() const { return *m_structure; }
  const Elimination_tasks& tasks() const { return m_tasks; }

  /// The dense kernels
  const Front_kernels<Real>& kernels() const { return m_kernels; }

  /// Layout of panels and updates
  const Panel_layout& layout() const { return m_kernels.layout; }

  /// Number of threads for a step of this duration on one thread: one if more would not pay off
  static int threads(double seconds);

  /// Bytes of the panels
  std::int64_t panel_bytes() const { return m_panel_offsets.back() * std::int64_t(sizeof(Real)); }

  /// Bytes of the panels and the updates
  std::int64_t bytes() const
  {
    return panel_bytes() + m_places.size() * std::int64_t(sizeof(Real));
  }

  /// \brief Factors A + diag(shift).
  /// \returns the first vertex, in the order of elimination, whose pivot is not positive; -1 if all
  /// are positive
  /// \throw std::bad_alloc
  int factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift);

  /// Releases the memory of the numbers; the next factorization allocates it anew
  void release();

  /// The panel of supernode s
  const Real* panel(int s) const { return m_panels.data() + m_panel_offsets[at(s)]; }

  /// Update of the last factorization for the kept vertices below supernode s
  /// \pre s has no parent
  const Real* update(int s) const { return m_updates.data() + m_places[s]; }

 private:
  struct Input;       // a matrix, a shift and the first bad column
  struct One_by_one;  // sequential loops
  struct Front;       // a supernode and the positions of its numbers

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  double seconds() const;
  void plan();
  Front front(int s);
  template <class Loops>
  void eliminate(int s, Input& input, Loops& loops);
  int eliminate_at_once(const Front& f, const Input& input);
  template <class Loops>
  int eliminate_in_pieces(const Front& f, const Input& input, Loops& loops);
  template <class Visitor>
  void for_each_child(const Front& f, const Visitor& visit) const;
  void add_children_to_panel(const Front& f, int begin, int end) const;
  void set_update(const Front& f, int begin, int end) const;
  void add_matrix(const Front& f, const Input& input) const;

  std::shared_ptr<const Supernodal_structure> m_structure;
  Front_kernels<Real> m_kernels;
  Elimination_tasks m_tasks;
  std::vector<std::int64_t> m_panel_offsets;  // size + 1
  bool m_is_parallel = false;
  Contribution_stack m_places;
  Aligned_array<Real> m_panels, m_updates;
};

}  // namespace Conformal_geometry_processing::internal
