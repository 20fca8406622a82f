// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Dirichlet_solver.h>

#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <string>

namespace Conformal_geometry_processing {

template <class Scalar>
internal::Dirichlet_solver<Scalar>::Dirichlet_solver(std::shared_ptr<const Sparse_pattern> pattern,
                                                     const std::vector<int>& given,
                                                     const Spin_solvers& solvers)
    : Dirichlet_solver(given, std::move(pattern), solvers.template solver<Scalar>())
{
  check("analysis", m_solver.analyze(m_matrix.pattern()));
}

template <class Scalar>
void internal::Dirichlet_solver<Scalar>::factorize(const Matrix& A)
{
  int k = 0;
  A.for_each_entry([&](int i, int j, const Scalar& a) {
    const bool is_free = !is_given(i) && !is_given(j);
    m_matrix.value(k++) = is_free ? a : internal::Scalar_traits<Scalar>::from_real(i == j ? 1 : 0);
  });
  m_weights.resize(0);
  check("factorization", m_solver.factorize(m_matrix, {}));
}

template <class Scalar>
void internal::Dirichlet_solver<Scalar>::factorize(const Matrix& A, Eigen::VectorXd w)
{
  m_weights = std::move(w);
  check("factorization", m_solver.factorize(A, m_weights));
}

template <class Scalar>
Block<Scalar> internal::Dirichlet_solver<Scalar>::solve(const Matrix& A, const Block<Scalar>& b,
                                                        const Block<Scalar>& values) const
{
  Block<Scalar> known = values, x;
  if (m_weights.size() > 0) {
    for (int i = 0; i < A.size(); ++i)
      for (Eigen::Index c = 0; c < b.cols(); ++c)
        known(i, c) = b(i, c) + m_weights[i] * values(i, c);
    check("solution", m_solver.solve(known, x));
    return x;
  }
  for (int i = 0; i < A.size(); ++i)
    if (!is_given(i)) known.row(i).setConstant(Scalar{});
  Block<Scalar> right = b - block_operator(A)(known);
  for (int i = 0; i < A.size(); ++i)
    if (is_given(i)) right.row(i) = values.row(i);
  check("solution", m_solver.solve(right, x));
  return x;
}

template <class Scalar>
internal::Dirichlet_solver<Scalar>::Dirichlet_solver(const std::vector<int>& given,
                                                     std::shared_ptr<const Sparse_pattern> pattern,
                                                     internal::Solver_ref<Scalar> solver)
    : m_matrix(std::move(pattern)),
      m_is_given(static_cast<std::size_t>(m_matrix.size()), 0),
      m_solver(std::move(solver))
{
  for (int i : given) m_is_given[static_cast<std::size_t>(i)] = 1;
}

template <class Scalar>
void internal::Dirichlet_solver<Scalar>::check(const char* step, Solver_status status)
{
  if (status != Solver_status::success)
    throw Solver_error("Dirichlet_solver", std::string(step) + " failed: " + to_string(status));
}

template class internal::Dirichlet_solver<double>;
template class internal::Dirichlet_solver<Quaternion<double>>;

}  // namespace Conformal_geometry_processing
