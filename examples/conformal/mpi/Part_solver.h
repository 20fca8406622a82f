// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_matrix.h"
#include "Distributed_solver.h"

#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace conformal::mpi {

/// \brief A solver of the library, for a matrix of which each process has the rows of its vertices
/// and solutions at all vertices of its part. Collective; by `Distributed_cholesky`, or by
/// `Distributed_solver` where the plan has no factor.
template <class Scalar>
class Part_solver final : public CGP::internal::Typed_solver_interface<Scalar> {
  using Interface = CGP::internal::Typed_solver_interface<Scalar>;
  using typename Interface::Matrix;
  using typename Interface::Shift;
  using Planes = CGP::internal::Scalar_planes<Scalar>;
  using Status = CGP::Solver_status;

 public:
  Part_solver(const Distributed_mesh& mesh, const Solution_plan& plan) : m_mesh(mesh), m_plan(plan)
  {}

  std::unique_ptr<Interface> another() const override
  {
    return std::make_unique<Part_solver>(m_mesh, m_plan);
  }
  std::unique_ptr<CGP::internal::Typed_solver_interface<double>> another_for_numbers()
      const override
  {
    return std::make_unique<Part_solver<double>>(m_mesh, m_plan);
  }

  // the parts have their own orderings
  Status analyze(const CGP::Sparse_pattern&) override { return Status::success; }
  Status analyze(const CGP::Sparse_pattern&, const CGP::internal::Ordering&) override
  {
    return Status::success;
  }
  Status analyze_with_positions(const CGP::Sparse_pattern&, const Eigen::Matrix3Xd&) override
  {
    return Status::success;
  }
  Status analyze_like(const CGP::Sparse_pattern&, const CGP::internal::Solver_interface&) override
  {
    return Status::success;
  }
  const CGP::internal::Ordering& ordering() const override { return m_ordering; }
  CGP::Solver_statistics statistics() const override { return {}; }
  void release() override
  {
    m_factor.reset();
    m_solver.reset();
    m_A.reset();
  }

  Status factorize(const Matrix& A, const Shift& shift) override
  {
    release();
    Matrix shifted = A;
    for (int v = 0; v < m_mesh.own_vertices(); ++v) {
      Scalar& diagonal = shifted.value(A.pattern().offsets[static_cast<std::size_t>(v)]);
      diagonal += Planes::put(Eigen::Vector4d(shift[v], 0, 0, 0).data());
    }
    if (m_plan.has_factor) {
      m_factor = factored(m_mesh, m_plan.border, shifted);
      if (is_rough) m_A.emplace(std::move(shifted));
      return m_factor ? Status::success : Status::not_positive_definite;
    }
    if (!m_matrix) m_matrix.emplace(m_mesh);
    m_matrix->set(shifted);
    m_solver.emplace(m_mesh, m_plan, m_matrix->get(), shifted);
    return Status::success;
  }
  Status factorize_preconditioner(const Matrix& A, const Shift& shift) override
  {
    return factorize(A, shift);
  }

  Status solve(const CGP::Block<Scalar>& b, CGP::Block<Scalar>& x) const override
  {
    solve_once(b, x);
    if (!m_A) return Status::success;
    CGP::Block<Scalar> rest = b, change;
    for (Eigen::Index c = 0; c < b.cols(); ++c) m_A->multiply(x.col(c), rest.col(c));
    rest = b - rest;
    solve_once(rest, change);
    x += change;
    return Status::success;
  }
  Status precondition(const CGP::Block<Scalar>& b, CGP::Block<Scalar>& x) const override
  {
    return solve(b, x);
  }

 private:
  // factors of quaternions have single precision, which one step of refinement makes up for
  static constexpr bool is_rough = Planes::size > 1;

  void solve_once(const CGP::Block<Scalar>& b, CGP::Block<Scalar>& x) const
  {
    const Eigen::Index own = m_mesh.own_vertices(), at_once = Planes::size == 1 ? 2 : 1;
    x.resize(b.rows(), b.cols());
    for (Eigen::Index first = 0; first < b.cols(); first += at_once) {
      const Eigen::Index count = (std::min)(at_once, b.cols() - first);
      Eigen::Matrix4Xd numbers = Eigen::Matrix4Xd::Zero(4, own);
      for (Eigen::Index v = 0; v < own; ++v)
        for (Eigen::Index k = 0; k < count; ++k) Planes::get(b(v, first + k), &numbers(k, v));
      if (m_factor)
        m_factor->solve(numbers);
      else
        m_solver->solve(numbers);
      Eigen::MatrixXd all(4, b.rows());
      all.leftCols(own) = numbers;
      m_mesh.update(all);
      for (Eigen::Index v = 0; v < b.rows(); ++v)
        for (Eigen::Index k = 0; k < count; ++k) x(v, first + k) = Planes::put(&all(k, v));
    }
  }

  const Distributed_mesh& m_mesh;
  const Solution_plan& m_plan;
  const CGP::internal::Ordering m_ordering;  // none
  std::unique_ptr<const Distributed_factor> m_factor;
  std::optional<Matrix> m_A;                           // that of a rough factor
  std::optional<Distributed_matrix<Scalar>> m_matrix;  // without a factor
  std::optional<Distributed_solver<Scalar>> m_solver;
};

/// solvers of the library for the surface
inline CGP::Spin_solvers part_solvers(const Distributed_mesh& mesh, const Solution_plan& plan)
{
  return CGP::Spin_solvers(
      [&] { return std::make_unique<Part_solver<double>>(mesh, plan); },
      [&] { return std::make_unique<Part_solver<CGP::Quaternion<double>>>(mesh, plan); });
}

}  // namespace conformal::mpi
