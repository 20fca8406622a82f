// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>

namespace Conformal_geometry_processing {

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
