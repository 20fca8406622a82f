// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_cholesky.h"
#include "Distributed_matrix.h"

#include <Quaternionic_linear_algebra/adapters/Petsc_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>

#include <Eigen/Core>

#include <memory>
#include <new>
#include <string>
#include <type_traits>

namespace conformal::mpi {

/// \brief How the systems of a surface in parts are solved: by a factor, where its share along the
/// borders, of which the first process has all, is not much larger than that of each process, or by
/// multigrid.
struct Solution_plan {
  /// Collective
  Solution_plan(const Distributed_mesh& mesh, bool wants_multigrid)
      : border(mesh), has_factor(!wants_multigrid && is_short(border.ranges.total(), mesh))
  {}

  Border_vertices border;
  bool has_factor;

 private:
  static bool is_short(double length, const Distributed_mesh& mesh)
  {
    const double numbers = 80;  // of a factor, for each vertex of 100,000 to a million
    const double vertices = static_cast<double>(mesh.ranges().total()) / processes();
    return length < 2000 || length * length / 2 < 2 * numbers * vertices;
  }
};

/// \brief Factors a matrix whose rows of own vertices are complete, in single precision where that
/// serves to precondition. Collective.
/// \return null if it is not positive definite
template <class Scalar>
std::unique_ptr<const Distributed_factor> factored(const Distributed_mesh& mesh,
                                                   const Border_vertices& border,
                                                   const CGP::Hermitian_sparse_matrix<Scalar>& A)
{
  if constexpr (!std::is_same_v<Scalar, double>) {
    auto rough = std::make_unique<const Distributed_cholesky<Scalar, float>>(mesh, border, A);
    if (rough->is_positive_definite()) return rough;
  }
  auto factor = std::make_unique<const Distributed_cholesky<Scalar, double>>(mesh, border, A);
  if (!factor->is_positive_definite()) return nullptr;
  return factor;
}

/// \brief Conjugate gradients for a matrix in parts, preconditioned by its factor, with which they
/// take a few iterations, or by multigrid. All functions are collective.
template <class Scalar>
class Distributed_solver {
  using Embedding = CGP::internal::Complex_embedding<Scalar>;

 public:
  /// \param matrix in which the values of A are \param A rows of own vertices are complete
  /// \param smooth of the own vertices: what grids have to represent; empty: constants
  /// \throw CGP::Solver_error if PETSc fails, or A is not positive definite
  Distributed_solver(const Distributed_mesh& mesh, const Solution_plan& plan, Mat matrix,
                     const CGP::Hermitian_sparse_matrix<Scalar>& A,
                     const Eigen::VectorXd& smooth = {})
      : m_factor(plan.has_factor ? require(factored(mesh, plan.border, A)) : nullptr),
        m_matrix(matrix),
        m_iteration(matrix, [&](PC pc) {
          if (m_factor)
            set_factor(pc);
          else
            set_multigrid(pc, mesh, A, smooth);
        })
  {}

  PC preconditioner() const { return m_iteration.preconditioner(); }

  /// \throw CGP::Solver_error if they do not converge
  void solve(Vec b, Vec x) const
  {
    const CGP::Solver_status status = m_iteration.solve(b, x);
    if (status != CGP::Solver_status::success)
      throw CGP::Solver_error("transform", to_string(status));
  }

  /// overwrites right-hand sides of the own vertices by solutions: a quaternion, or two numbers
  void solve(Eigen::Matrix4Xd& numbers) const
  {
    Petsc_vec b, x;
    check_petsc(MatCreateVecs(m_matrix, x.renew(), b.renew()));
    set(numbers, b.get());
    solve(b.get(), x.get());
    get(x.get(), numbers);
  }

 private:
  static std::unique_ptr<const Distributed_factor> require(
      std::unique_ptr<const Distributed_factor> factor)
  {
    const auto status = CGP::Solver_status::not_positive_definite;
    if (!factor) throw CGP::Solver_error("transform", to_string(status));
    return factor;
  }

  static void get(Vec v, Eigen::Matrix4Xd& numbers)
  {
    with_values(v, [&](const PetscScalar* entries) {
      for (auto column : numbers.colwise()) {
        column = numbers_of(entries);
        entries += Embedding::width;
      }
    });
  }

  static void set(const Eigen::Matrix4Xd& numbers, Vec v)
  {
    with_values(v, [&](PetscScalar* entries) {
      for (const auto column : numbers.colwise()) {
        put(column, entries);
        entries += Embedding::width;
      }
    });
  }

  void set_factor(PC pc) const
  {
    check_petsc(PCSetType(pc, PCSHELL));
    check_petsc(PCShellSetContext(pc, const_cast<Distributed_factor*>(m_factor.get())));
    check_petsc(PCShellSetApply(pc, apply));
  }

  static PetscErrorCode apply(PC pc, Vec b, Vec x)
  {
    try {
      void* context = nullptr;
      check_petsc(PCShellGetContext(pc, &context));
      PetscInt rows = 0;
      check_petsc(VecGetLocalSize(b, &rows));
      Eigen::Matrix4Xd numbers(4, rows / Embedding::width);
      get(b, numbers);
      static_cast<const Distributed_factor*>(context)->solve(numbers);
      set(numbers, x);
      return 0;
    } catch (const std::bad_alloc&) {  // exceptions must not propagate through PETSc
      return PETSC_ERR_MEM;
    }
  }

  // A quaternion, or the right-hand sides in a complex one
  static Eigen::Vector4d numbers_of(const PetscScalar* entries)
  {
    if constexpr (Embedding::width == 1) {
      return {entries[0].real(), entries[0].imag(), 0, 0};
    } else {
      const auto q = Embedding::from_entries(entries);
      return {q.w, q.x, q.y, q.z};
    }
  }

  static void put(const Eigen::Vector4d& numbers, PetscScalar* entries)
  {
    if constexpr (Embedding::width == 1)
      entries[0] = {numbers[0], numbers[1]};
    else
      Embedding::to_entries({numbers[0], numbers[1], numbers[2], numbers[3]}, entries);
  }

  static void set_multigrid(PC pc, const Distributed_mesh& mesh,
                            const CGP::Hermitian_sparse_matrix<Scalar>& A,
                            const Eigen::VectorXd& smooth)
  {
    CGP::Hermitian_sparse_matrix<double> real(A.shared_pattern());
    for (int k = 0; k < A.pattern().size_of_entries(); ++k)
      real.value(k) = CGP::internal::Scalar_traits<Scalar>::real(A.value(k));
    Distributed_matrix<double> coarsened(mesh);
    coarsened.set(real);
    if (smooth.size() > 0) set_smooth_vector(coarsened, smooth);
    CGP::internal::set_petsc_multigrid(pc, coarsened.get(), Embedding::width);
  }

  static void set_smooth_vector(const Distributed_matrix<double>& matrix,
                                const Eigen::VectorXd& smooth)
  {
    const Petsc_vec v = matrix.make_vector();
    with_values(v.get(), [&](PetscScalar* values) {
      for (Eigen::Index i = 0; i < smooth.size(); ++i) values[i] = smooth[i];
    });
    check_petsc(VecNormalize(v.get(), nullptr));
    const Vec vector = v.get();
    CGP::internal::Petsc_handle<MatNullSpace, MatNullSpaceDestroy> space;
    check_petsc(MatNullSpaceCreate(PETSC_COMM_WORLD, PETSC_FALSE, 1, &vector, space.renew()));
    check_petsc(MatSetNearNullSpace(matrix.get(), space.get()));
  }

  std::unique_ptr<const Distributed_factor> m_factor;
  Mat m_matrix;
  CGP::internal::Petsc_conjugate_gradients m_iteration;
};

}  // namespace conformal::mpi
