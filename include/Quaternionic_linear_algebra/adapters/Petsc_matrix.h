// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/adapters/Embedded_hermitian_solver.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <petscksp.h>

#include <array>
#include <complex>
#include <cstddef>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

static_assert(std::is_same_v<PetscScalar, std::complex<double>>,
              "PETSc must be built for complex numbers of double precision");

// Converts the error code of a PETSc call to an exception.
inline void check_petsc(PetscErrorCode code)
{
  if (code == 0) return;
  if (code == PETSC_ERR_MEM) throw std::bad_alloc();
  const char* kind = nullptr;
  char* what = nullptr;
  PetscErrorMessage(code, &kind, &what);
  std::string message = "error " + std::to_string(code);
  for (const char* part : {kind, static_cast<const char*>(what)})
    if (part != nullptr && *part != '\0') message += std::string(", ") + part;
  throw Solver_error("PETSc", message);
}

// During its lifetime PETSc returns error codes instead of printing messages.
class Quiet_petsc {
 public:
  Quiet_petsc() { PetscPushErrorHandler(PetscReturnErrorHandler, nullptr); }
  Quiet_petsc(const Quiet_petsc&) = delete;
  Quiet_petsc& operator=(const Quiet_petsc&) = delete;
  ~Quiet_petsc() { PetscPopErrorHandler(); }
};

inline bool petsc_is_running()
{
  PetscBool is_initialized = PETSC_FALSE, is_finalized = PETSC_FALSE;
  PetscInitialized(&is_initialized);
  PetscFinalized(&is_finalized);
  return is_initialized && !is_finalized;
}

// Owns a PETSc object. Objects that still exist when PETSc is finalized are not destroyed.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class Petsc_handle {
 public:
  Petsc_handle() = default;
  Petsc_handle(Petsc_handle&& other) noexcept : m_object(std::exchange(other.m_object, nullptr)) {}
  Petsc_handle& operator=(Petsc_handle&& other) noexcept
  {
    std::swap(m_object, other.m_object);
    return *this;
  }
  ~Petsc_handle() { release(); }

  Object get() const { return m_object; }

  // Destroys the object and returns its address, for functions that create a new one
  Object* renew()
  {
    release();
    return &m_object;
  }

 private:
  void release()
  {
    if (m_object != nullptr && petsc_is_running()) destroy(&m_object);
    m_object = nullptr;
  }

  Object m_object = nullptr;
};

using Petsc_vec = Petsc_handle<Vec, VecDestroy>;
using Petsc_mat = Petsc_handle<Mat, MatDestroy>;
using Petsc_scatter = Petsc_handle<VecScatter, VecScatterDestroy>;
using Petsc_pc = Petsc_handle<PC, PCDestroy>;
using Petsc_ksp = Petsc_handle<KSP, KSPDestroy>;

/// \brief A Hermitian sparse matrix, replicated on all processes of `PETSC_COMM_WORLD`, as a
/// complex PETSc matrix that is distributed by rows over them.
///
/// Every process passes the same vectors and the same matrix, of which it keeps a range of rows.
/// Vertex `order[k]` has the rows width k ... width k + width - 1: one for real scalars, two for
/// quaternions. All functions are collective. Errors throw `Solver_error` or std::bad_alloc.
template <class Scalar>
class Petsc_matrix {
 public:
  using FT = typename Scalar_traits<Scalar>::FT;
  static constexpr int width = Complex_embedding<Scalar>::width;

  Petsc_matrix(const Sparse_pattern& pattern, const Ordering& order)
      : m_order(order), m_new_of_old(inverse_permutation(order))
  {
    PetscInt mine = PETSC_DECIDE, all = pattern.size(), end = 0;
    internal::check_petsc(PetscSplitOwnership(PETSC_COMM_WORLD, &mine, &all));
    MPI_Scan(&mine, &end, 1, MPIU_INT, MPI_SUM, PETSC_COMM_WORLD);
    m_end = static_cast<int>(end);
    m_begin = m_end - static_cast<int>(mine);
    create(width * mine, width * all);
    reserve(pattern);
    const internal::Petsc_vec vector = make_vector();
    internal::check_petsc(
        VecScatterCreateToAll(vector.get(), m_to_all.renew(), m_everything.renew()));
  }

  Mat get() const { return m_matrix.get(); }
  const Ordering& ordering() const { return m_order; }
  int size() const { return static_cast<int>(m_order.size()); }

  /// Sets the values of A + diag(shift); `shift` may be empty
  void set_values(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    A.for_each_entry([&](int i, int j, const Scalar& a) {
      const bool is_shifted = i == j && shift.size() > 0;
      set_block(i, j, is_shifted ? a + Scalar_traits<Scalar>::from_real(shift[i]) : a);
      if (i != j) set_block(j, i, conjugate(a));
    });
    internal::check_petsc(MatAssemblyBegin(get(), MAT_FINAL_ASSEMBLY));
    internal::check_petsc(MatAssemblyEnd(get(), MAT_FINAL_ASSEMBLY));
    internal::check_petsc(MatSetOption(get(), MAT_HERMITIAN, PETSC_TRUE));  // reset by assembly
  }

  /// Creates a vector distributed like the rows
  internal::Petsc_vec make_vector() const
  {
    internal::Petsc_vec v;
    internal::check_petsc(MatCreateVecs(get(), v.renew(), nullptr));
    return v;
  }

  /// Copies the local part of a column of b
  void to_petsc(const Block<Scalar>& b, Eigen::Index column, Vec v) const
  {
    PetscScalar* values = nullptr;
    internal::check_petsc(VecGetArrayWrite(v, &values));
    for (int k = m_begin; k < m_end; ++k) {
      typename Embedding::Entry entries[width];
      Embedding::to_entries(b(m_order[static_cast<std::size_t>(k)], column), entries);
      for (const auto& entry : entries) *values++ = entry;
    }
    values -= width * (m_end - m_begin);
    internal::check_petsc(VecRestoreArrayWrite(v, &values));
  }

  /// Gathers the whole vector, on every process, in a column of b
  void from_petsc(Vec v, Eigen::Index column, Block<Scalar>& b) const
  {
    for (auto step : {VecScatterBegin, VecScatterEnd})
      internal::check_petsc(
          step(m_to_all.get(), v, m_everything.get(), INSERT_VALUES, SCATTER_FORWARD));
    const PetscScalar* values = nullptr;
    internal::check_petsc(VecGetArrayRead(m_everything.get(), &values));
    for (int k = 0; k < size(); ++k)
      b(m_order[static_cast<std::size_t>(k)], column) = scalar(values + width * k);
    internal::check_petsc(VecRestoreArrayRead(m_everything.get(), &values));
  }

 private:
  using Embedding = Complex_embedding<Scalar>;

  bool is_mine(int k) const { return m_begin <= k && k < m_end; }
  int place(int old) const { return m_new_of_old[static_cast<std::size_t>(old)]; }

  static Scalar scalar(const PetscScalar* values)
  {
    if constexpr (width == 1)
      return values->real();
    else
      return Embedding::from_entries(values);
  }

  void create(PetscInt rows, PetscInt all)
  {
    internal::check_petsc(MatCreate(PETSC_COMM_WORLD, m_matrix.renew()));
    internal::check_petsc(MatSetSizes(get(), rows, rows, all, all));
    internal::check_petsc(MatSetBlockSize(get(), width));
    internal::check_petsc(MatSetType(get(), MATAIJ));
  }

  // Preallocates the blocks of every row, inside and outside the columns of this process.
  void reserve(const Sparse_pattern& pattern)
  {
    const std::size_t rows = static_cast<std::size_t>(m_end - m_begin);
    std::vector<PetscInt> inside(rows, 0), outside(rows, 0);
    const auto count = [&](int k, int l) {
      if (is_mine(k)) ++(is_mine(l) ? inside : outside)[static_cast<std::size_t>(k - m_begin)];
    };
    for (int j = 0; j < pattern.size(); ++j)
      for (int e = pattern.offsets[static_cast<std::size_t>(j)];
           e < pattern.offsets[static_cast<std::size_t>(j) + 1]; ++e) {
        const int k = place(pattern.indices[static_cast<std::size_t>(e)]), l = place(j);
        count(k, l);
        if (k != l) count(l, k);
      }
    internal::check_petsc(
        MatXAIJSetPreallocation(get(), width, inside.data(), outside.data(), nullptr, nullptr));
  }

  void set_block(int i, int j, const Scalar& a)
  {
    const PetscInt k = place(i), l = place(j);
    if (!is_mine(static_cast<int>(k))) return;
    const auto block = Embedding::block(a);
    std::array<PetscScalar, width * width> values;  // row-major
    for (int r = 0; r < width; ++r)
      for (int c = 0; c < width; ++c) values[static_cast<std::size_t>(width * r + c)] = block(r, c);
    internal::check_petsc(MatSetValuesBlocked(get(), 1, &k, 1, &l, values.data(), INSERT_VALUES));
  }

  Ordering m_order;
  std::vector<int> m_new_of_old;
  int m_begin = 0, m_end = 0;  // the vertices of this process, in the new order
  internal::Petsc_mat m_matrix;
  internal::Petsc_scatter m_to_all;
  internal::Petsc_vec m_everything;
};

}  // namespace Conformal_geometry_processing::internal
