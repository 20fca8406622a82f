// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Quaternionic_linear_algebra/adapters/Petsc_matrix.h
#include <Quaternionic_linear_algebra/adapters/Petsc_matrix.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test::petsc_matrix_tests {

template <class Scalar_>
class Petsc_matrix : public testing::Test {
 protected:
  using Scalar = Scalar_;

  static constexpr int n = 23;

  // A x by PETSc
  CGP::Block<Scalar> product(const CGP::Block<Scalar>& x) const
  {
    const auto v = distributed.make_vector(), w = distributed.make_vector();
    CGP::Block<Scalar> y(x.rows(), x.cols());
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      distributed.to_petsc(x, c, v.get());
      CGP::internal::check_petsc(MatMult(distributed.get(), v.get(), w.get()));
      distributed.from_petsc(w.get(), c, y);
    }
    return y;
  }

  Pattern pattern = random_pattern(n, 1);
  CGP::internal::Petsc_matrix<Scalar> distributed{*pattern, random_permutation(n, 2)};
};

using Scalars = testing::Types<double, Quaternion<double>>;
TYPED_TEST_SUITE(Petsc_matrix, Scalars);

TYPED_TEST(Petsc_matrix, gives_vectors_back_on_every_process)
{
  const auto x = random_block<TypeParam>(this->n, 2, 3);
  const auto v = this->distributed.make_vector();
  CGP::Block<TypeParam> y = CGP::Block<TypeParam>::Constant(this->n, 2, TypeParam{});
  this->distributed.to_petsc(x, 0, v.get());
  this->distributed.from_petsc(v.get(), 1, y);
  EXPECT_EQ(real_columns(y).col(1), real_columns(x).col(0));
  EXPECT_EQ(real_columns(y).col(0).norm(), 0);
}

TYPED_TEST(Petsc_matrix, multiplies_as_the_matrix_does)
{
  for (const std::uint64_t seed : {4u, 5u}) {
    const auto A = random_hermitian<TypeParam>(this->pattern, seed);
    this->distributed.set_values(A, {});
    const auto x = random_block<TypeParam>(this->n, 2, 6);
    const Eigen::MatrixXd expected = real_form(A) * real_columns(x);
    EXPECT_LE((real_columns(this->product(x)) - expected).norm(), 1e-14 * expected.norm());
  }
}

TYPED_TEST(Petsc_matrix, adds_the_shift_to_the_diagonal)
{
  const auto A = random_hermitian<TypeParam>(this->pattern, 7);
  const Eigen::VectorXd shift = random_numbers(this->n, 8);
  this->distributed.set_values(A, shift);
  const auto x = random_block<TypeParam>(this->n, 1, 9);
  const Eigen::MatrixXd expected = real_form(plus_diagonal(A, shift)) * real_columns(x);
  EXPECT_LE((real_columns(this->product(x)) - expected).norm(), 1e-14 * expected.norm());
}

TYPED_TEST(Petsc_matrix, gives_every_process_a_fair_share_of_the_rows)
{
  PetscInt begin = 0, end = 0;
  int processes = 1;
  CGP::internal::check_petsc(MatGetOwnershipRange(this->distributed.get(), &begin, &end));
  MPI_Comm_size(PETSC_COMM_WORLD, &processes);
  const int vertices = static_cast<int>(end - begin) / this->distributed.width;
  EXPECT_GE(vertices, this->n / processes);
  EXPECT_LE(vertices, this->n / processes + 1);
}

}  // namespace cgp_test::petsc_matrix_tests
