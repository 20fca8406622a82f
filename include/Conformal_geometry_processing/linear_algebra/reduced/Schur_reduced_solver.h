// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_substitution.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Reduced_complement.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Reduced_form.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief Solves with R = B^T (X + diag(shift)) B by eliminating the unreduced rows first, as
/// quaternions, and the reduced ones last, as real numbers.
///
/// The Schur complement of the reduced rows is a dense quaternionic matrix; restricted to their
/// planes it becomes a dense real one of twice their number, which is factored as such. The best
/// choice if the boundary is short, as for a disk. For all functions see
/// `Reduced_hermitian_solver`.
class Schur_reduced_solver {
 public:
  using FT = double;
  using Scalar = Quaternion<FT>;

  /// \param order of all rows; the reduced ones are moved to its end
  Solver_status analyze(const Sparse_pattern& pattern, const Reduced_rows& rows,
                        const Ordering& order)
  {
    return internal::guarded([&] {
      m_factor.reset();
      m_is_factorized = false;
      if (pattern.size() == 0 || rows.size() != pattern.size() ||
          order.size() != pattern.offsets.size() - 1 || inverse_permutation(order).empty())
        return Solver_status::wrong_state;
      auto structure = std::make_shared<const Supernodal_structure>(
          pattern, reduced_last(order, rows), rows.size_of_reduced());
      m_rows = rows;
      m_entries = pattern.size_of_entries();
      m_complement.emplace(pattern, *structure);
      m_factor.emplace(std::move(structure));
      return Solver_status::success;
    });
  }

  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& X, const Vector<FT>& shift,
                          const Reduced_basis<FT>& basis)
  {
    return internal::guarded([&] {
      if (!m_factor || X.size() != m_rows.size() || X.pattern().size_of_entries() != m_entries ||
          basis.rows() != m_rows || (shift.size() != 0 && shift.size() != X.size()))
        return Solver_status::wrong_state;
      m_is_factorized = false;
      if (!is_finite(X) || !shift.allFinite()) return Solver_status::numerical_issue;
      m_complement->assemble(X, shift, basis);
      if (m_factor->factorize(X, shift) >= 0) return Solver_status::not_positive_definite;
      m_complement->add(*m_factor);
      if (!m_complement->factorize()) return Solver_status::not_positive_definite;
      m_is_factorized = true;
      return Solver_status::success;
    });
  }

  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return internal::guarded([&] {
      if (!m_is_factorized || b.rows() != m_rows.size()) return Solver_status::wrong_state;
      const Ordering& order = m_factor->structure().order();
      Substitution substitution(*m_factor);
      Block<Scalar> solution(b.rows(), b.cols());
      Vector<Scalar> y(b.rows());
      for (Eigen::Index c = 0; c < b.cols(); ++c) {
        for (Eigen::Index k = 0; k < y.size(); ++k) y[k] = b(order[at(k)], c);
        FT* const numbers = reinterpret_cast<FT*>(y.data());
        substitution.forward(numbers);
        m_complement->solve(y);
        substitution.backward(numbers);
        for (Eigen::Index k = 0; k < y.size(); ++k) solution(order[at(k)], c) = y[k];
        if (!components(y).allFinite()) return Solver_status::numerical_issue;
      }
      x = std::move(solution);
      return Solver_status::success;
    });
  }

  void release()
  {
    m_is_factorized = false;
    if (m_factor) m_factor->release();
    if (m_complement) m_complement->release();
  }

  /// Cost of both factors, in real numbers
  Solver_statistics statistics() const
  {
    Solver_statistics s;
    if (!m_factor) return s;
    s.factor_entries = 4 * m_factor->structure().stored_entries() + m_complement->factor_entries();
    s.flops = 16 * m_factor->structure().operations() + m_complement->flops();
    s.bytes = static_cast<double>(m_factor->bytes()) + m_complement->bytes();
    return s;
  }

 private:
  using Factor = Supernodal_factor<Scalar, FT>;
  using Substitution = Supernodal_substitution<Scalar, FT>;

  static std::size_t at(Eigen::Index i) { return static_cast<std::size_t>(i); }

  static bool is_finite(const Hermitian_sparse_matrix<Scalar>& X)
  {
    bool is_finite = true;
    X.for_each_entry([&](int, int, const Scalar& x) {
      is_finite = is_finite && std::isfinite(squared_norm(x));
    });
    return is_finite;
  }

  Reduced_rows m_rows;
  int m_entries = 0;
  std::optional<Factor> m_factor;
  std::optional<Reduced_complement> m_complement;
  bool m_is_factorized = false;
};

}  // namespace Conformal_geometry_processing::internal
