// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_mesh.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/adapters/Petsc_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace conformal::mpi {

using CGP::internal::check_petsc;
using CGP::internal::Petsc_vec;

/// a matrix of blocks on the graph of the surface, of which each process has the rows of its
/// vertices
template <class Scalar>
class Distributed_matrix {
  using Embedding = CGP::internal::Complex_embedding<Scalar>;
  static constexpr int width = Embedding::width;

 public:
  explicit Distributed_matrix(const Distributed_mesh& mesh) : m_mesh(mesh)
  {
    const PetscInt rows = width * mesh.own_vertices(), all = width * mesh.ranges().total();
    check_petsc(MatCreate(PETSC_COMM_WORLD, m_matrix.renew()));
    check_petsc(MatSetSizes(get(), rows, rows, all, all));
    check_petsc(MatSetBlockSize(get(), width));
    check_petsc(MatSetType(get(), MATAIJ));
    const auto own = static_cast<std::size_t>(mesh.own_vertices());
    std::vector<PetscInt> inside(own, 1), outside(own, 0);
    for (const auto& [i, j] : mesh.mesh().ends())
      for (const auto& [a, b] : {std::pair(i, j), std::pair(j, i)})
        if (a < mesh.own_vertices())
          ++(b < mesh.own_vertices() ? inside : outside)[static_cast<std::size_t>(a)];
    check_petsc(
        MatXAIJSetPreallocation(get(), width, inside.data(), outside.data(), nullptr, nullptr));
  }

  Mat get() const { return m_matrix.get(); }

  /// Sets the rows of the own vertices, which are complete in the part
  void set(const CGP::Hermitian_sparse_matrix<Scalar>& A)
  {
    A.for_each_entry([&](int i, int j, const Scalar& a) {
      if (i < m_mesh.own_vertices()) put(i, j, a);
      if (i != j && j < m_mesh.own_vertices()) put(j, i, CGP::conjugate(a));
    });
    check_petsc(MatAssemblyBegin(get(), MAT_FINAL_ASSEMBLY));
    check_petsc(MatAssemblyEnd(get(), MAT_FINAL_ASSEMBLY));
    check_petsc(MatSetOption(get(), MAT_HERMITIAN, PETSC_TRUE));
  }

  /// Says that constants are in the kernel, or nearly so: solutions have none
  void set_kernel_to_constants() const
  {
    CGP::internal::Petsc_handle<MatNullSpace, MatNullSpaceDestroy> kernel;
    check_petsc(MatNullSpaceCreate(PETSC_COMM_WORLD, PETSC_TRUE, 0, nullptr, kernel.renew()));
    check_petsc(MatSetNullSpace(get(), kernel.get()));
  }

  Petsc_vec make_vector() const
  {
    Petsc_vec v;
    check_petsc(MatCreateVecs(get(), v.renew(), nullptr));
    return v;
  }

 private:
  void put(int i, int j, const Scalar& a)
  {
    const PetscInt row = m_mesh.number(i), column = m_mesh.number(j);
    const auto block = Embedding::block(a);
    std::array<PetscScalar, width * width> values;  // row-major
    for (int r = 0; r < width; ++r)
      for (int c = 0; c < width; ++c) values[static_cast<std::size_t>(width * r + c)] = block(r, c);
    check_petsc(MatSetValuesBlocked(get(), 1, &row, 1, &column, values.data(), INSERT_VALUES));
  }

  const Distributed_mesh& m_mesh;
  CGP::internal::Petsc_mat m_matrix;
};

/// calls visit(values) with the numbers of this process
template <class Visit>
void with_values(Vec v, const Visit& visit)
{
  PetscScalar* values = nullptr;
  check_petsc(VecGetArray(v, &values));
  visit(values);
  check_petsc(VecRestoreArray(v, &values));
}

}  // namespace conformal::mpi
