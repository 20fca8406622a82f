// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>

#include <Quaternionic_linear_algebra/dense/Solver_status.h>

namespace Conformal_geometry_processing {

std::shared_ptr<const Sparse_pattern> reduced_pattern(const Sparse_pattern& pattern,
                                                      const internal::Reduced_rows& rows)
{
  auto reduced = std::make_shared<Sparse_pattern>();
  reduced->offsets.reserve(static_cast<std::size_t>(rows.dimension()) + 1);
  reduced->indices.reserve(16 * pattern.indices.size());
  reduced->offsets.push_back(0);
  for (int j = 0; j < pattern.size(); ++j)
    for (int c = 0; c < rows.dimension(j); ++c) {
      const int begin = pattern.offsets[static_cast<std::size_t>(j)];
      for (int k = begin; k < pattern.offsets[static_cast<std::size_t>(j) + 1]; ++k) {
        const int i = pattern.indices[static_cast<std::size_t>(k)];
        for (int r = k == begin ? c : 0; r < rows.dimension(i); ++r)
          reduced->indices.push_back(rows.first(i) + r);
      }
      reduced->offsets.push_back(static_cast<int>(reduced->indices.size()));
    }
  return reduced;
}

internal::Ordering reduced_ordering(const internal::Ordering& order,
                                    const internal::Reduced_rows& rows)
{
  internal::Ordering coordinates;
  coordinates.reserve(static_cast<std::size_t>(rows.dimension()));
  for (int i : order)
    for (int c = 0; c < rows.dimension(i); ++c) coordinates.push_back(rows.first(i) + c);
  return coordinates;
}

Solver_status internal::Real_reduced_solver::analyze(const Sparse_pattern& pattern,
                                                     const internal::Reduced_rows& rows,
                                                     const internal::Ordering& order)
{
  return internal::guarded([&] {
    m_rows = Reduced_rows();
    m_is_factorized = false;
    if (pattern.size() == 0 || rows.size() != pattern.size() ||
        order.size() != pattern.offsets.size() - 1 || inverse_permutation(order).empty())
      return Solver_status::wrong_state;
    m_matrix = Hermitian_sparse_matrix<FT>(reduced_pattern(pattern, rows));
    m_entries = pattern.size_of_entries();
    const Solver_status status =
        m_solver.analyze(m_matrix.pattern(), reduced_ordering(order, rows));
    if (status == Solver_status::success) m_rows = rows;
    return status;
  });
}

Solver_status internal::Real_reduced_solver::factorize(const Hermitian_sparse_matrix<Scalar>& X,
                                                       const Vector<FT>& shift,
                                                       const internal::Reduced_basis<FT>& basis)
{
  return internal::guarded([&] {
    if (m_rows.size() == 0 || X.size() != m_rows.size() ||
        X.pattern().size_of_entries() != m_entries || basis.rows() != m_rows ||
        (shift.size() != 0 && shift.size() != X.size()))
      return Solver_status::wrong_state;
    m_is_factorized = false;
    m_basis = basis;
    assemble_reduced_matrix(X, m_basis, m_matrix);
    const Vector<FT> reduced_shift =
        shift.size() == 0 ? Vector<FT>() : reduced_diagonal(shift, m_rows);
    const Solver_status status = m_solver.factorize(m_matrix, reduced_shift);
    m_is_factorized = status == Solver_status::success;
    return status;
  });
}

Solver_status internal::Real_reduced_solver::solve(const Block<Scalar>& b, Block<Scalar>& x) const
{
  return internal::guarded([&] {
    if (!m_is_factorized || b.rows() != m_rows.size()) return Solver_status::wrong_state;
    Block<FT> solution;
    const Solver_status status = m_solver.solve(m_basis.coordinates(b), solution);
    if (status == Solver_status::success) x = m_basis.embed(solution);
    return status;
  });
}

void internal::Real_reduced_solver::release()
{
  m_is_factorized = false;
  release_factor(m_solver);
}

Solver_status internal::Reduced_hermitian_solver::analyze(const Sparse_pattern& pattern,
                                                          const internal::Reduced_rows& rows)
{
  return adopt(pattern, rows, nullptr);
}

Solver_status internal::Reduced_hermitian_solver::analyze_with_positions(
    const Sparse_pattern& pattern, const internal::Reduced_rows& rows,
    const Eigen::Matrix3Xd& positions)
{
  if (positions.cols() != pattern.size()) return forget();
  return adopt(pattern, rows, &positions);
}

Solver_status internal::Reduced_hermitian_solver::analyze(const Sparse_pattern& pattern,
                                                          const internal::Reduced_rows& rows,
                                                          const internal::Ordering& order)
{
  return internal::guarded([&] {
    const bool fits = pattern.size() > 0 && rows.size() == pattern.size() &&
                      order.size() == pattern.offsets.size() - 1 &&
                      !inverse_permutation(order).empty();
    return fits ? adopt(pattern, rows, choose_reduced_form(pattern, rows, order)) : forget();
  });
}

Solver_status internal::Reduced_hermitian_solver::factorize(
    const Hermitian_sparse_matrix<Scalar>& X, const Vector<FT>& shift,
    const internal::Reduced_basis<FT>& basis)
{
  return std::visit([&](auto& solver) { return solver.factorize(X, shift, basis); }, m_solver);
}

Solver_status internal::Reduced_hermitian_solver::solve(const Block<Scalar>& b,
                                                        Block<Scalar>& x) const
{
  return std::visit([&](auto& solver) { return solver.solve(b, x); }, m_solver);
}

void internal::Reduced_hermitian_solver::release()
{
  std::visit([](auto& solver) { solver.release(); }, m_solver);
}

Solver_statistics internal::Reduced_hermitian_solver::statistics() const
{
  return std::visit([](auto& solver) { return solver.statistics(); }, m_solver);
}

Solver_status internal::Reduced_hermitian_solver::forget()
{
  m_solver.emplace<internal::Schur_reduced_solver>();
  return Solver_status::wrong_state;
}

Solver_status internal::Reduced_hermitian_solver::adopt(const Sparse_pattern& pattern,
                                                        const internal::Reduced_rows& rows,
                                                        const Eigen::Matrix3Xd* positions)
{
  const int factorizations = 2;
  return internal::guarded([&] {
    if (pattern.size() == 0 || rows.size() != pattern.size()) return forget();
    return adopt(pattern, rows, choose_reduced_form(pattern, rows, positions, factorizations));
  });
}

Solver_status internal::Reduced_hermitian_solver::adopt(const Sparse_pattern& pattern,
                                                        const internal::Reduced_rows& rows,
                                                        const internal::Reduced_form& form)
{
  if (form.is_real)
    return m_solver.emplace<internal::Real_reduced_solver>().analyze(pattern, rows, form.order);
  return m_solver.emplace<internal::Schur_reduced_solver>().analyze(pattern, rows, form.order);
}

}  // namespace Conformal_geometry_processing
