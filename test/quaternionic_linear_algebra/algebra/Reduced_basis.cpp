// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>
#include <Quaternionic_linear_algebra/algebra/rotor.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/reduced_problem.h"

#include <limits>

namespace cgp_test::reduced_basis_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Reduced_rows;
using Basis = CGP::internal::Reduced_basis<double>;
using Q = Quaternion<double>;

TEST(Reduced_rows, number_their_coordinates_row_by_row)
{
  const Reduced_rows rows(5, {3, 0});
  EXPECT_EQ(rows.size(), 5);
  EXPECT_EQ(rows.size_of_reduced(), 2);
  EXPECT_EQ(rows.dimension(), 16);
  const int first[] = {0, 2, 6, 10, 12}, dimension[] = {2, 4, 4, 2, 4};
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(rows.first(i), first[i]);
    EXPECT_EQ(rows.dimension(i), dimension[i]);
    EXPECT_EQ(rows.is_reduced(i), i == 0 || i == 3);
  }
}

TEST(Reduced_rows, are_equal_whatever_their_order)
{
  EXPECT_EQ(Reduced_rows(5, {3, 0}), Reduced_rows(5, {0, 3}));
  EXPECT_NE(Reduced_rows(5, {3, 0}), Reduced_rows(5, {3}));
  EXPECT_NE(Reduced_rows(5, {3, 0}), Reduced_rows(6, {3, 0}));
  EXPECT_EQ(Reduced_rows(), Reduced_rows(0, {}));
}

TEST(Reduced_rows, refuse_rows_that_do_not_exist)
{
  EXPECT_THROW(Reduced_rows(5, {5}), CGP::Precondition_error);
  EXPECT_THROW(Reduced_rows(5, {0, -1}), CGP::Precondition_error);
}

TEST(Reduced_rows, refuse_a_row_that_comes_twice)
{
  EXPECT_THROW(Reduced_rows(5, {1, 2, 1}), CGP::Precondition_error);
}

Reduced_problem on_a_ring()
{
  return reduced_problem(random_pattern(11, 1), {7, 2, 3, 10}, 2);
}

TEST(Reduced_basis, embeds_as_its_matrix)
{
  const Reduced_problem p = on_a_ring();
  const Eigen::MatrixXd B = p.dense_basis(), c = random_block<double>(int(B.cols()), 3, 3);
  EXPECT_LE((real_columns(p.basis().embed(c)) - B * c).norm(), 1e-15 * c.norm());
}

TEST(Reduced_basis, takes_coordinates_by_the_adjoint)
{
  const Reduced_problem p = on_a_ring();
  const Eigen::MatrixXd c = random_block<double>(p.rows().dimension(), 3, 4);
  const auto x = random_block<Q>(11, 3, 5);
  const Eigen::MatrixXd embedded = real_columns(p.basis().embed(c));
  const Eigen::MatrixXd difference =
      embedded.transpose() * real_columns(x) - c.transpose() * p.basis().coordinates(x);
  EXPECT_LE(difference.norm(), 1e-13);
}

TEST(Reduced_basis, finds_the_coordinates_that_it_has_embedded)
{
  const Reduced_problem p = on_a_ring();
  const Eigen::MatrixXd c = random_block<double>(p.rows().dimension(), 2, 6);
  EXPECT_LE((p.basis().coordinates(p.basis().embed(c)) - c).norm(), 1e-14 * c.norm());
}

TEST(Reduced_basis, projects_to_the_nearest_vector_of_the_space)
{
  const Reduced_problem p = on_a_ring();
  const Eigen::MatrixXd B = p.dense_basis();
  const auto x = random_block<Q>(11, 2, 7);
  const Eigen::MatrixXd expected = B * B.transpose() * real_columns(x);
  EXPECT_LE((real_columns(p.basis().project(x)) - expected).norm(), 1e-14);
}

TEST(Reduced_basis, knows_the_vectors_of_every_row)
{
  const Reduced_problem p = on_a_ring();
  EXPECT_EQ(p.basis().vector(2, 1), p.planes[1][1]);
  EXPECT_EQ(p.basis().vector(7, 0), p.planes[0][0]);
  EXPECT_EQ(p.basis().vector(4, 2), (Q{0, 0, 1, 0}));
}

TEST(Reduced_basis, of_a_prescribed_direction_turns_it_and_is_closed_under_it_from_the_right)
{
  Random random(8);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector3d U = random.vector().normalized(), V = random.vector().normalized();
    const Q q = CGP::rotor(U, V), v = CGP::imaginary(V);
    const Basis basis(1, {0}, {{q, -(q * v)}});
    const CGP::Block<Q> x = basis.embed(random_block<double>(2, 1, std::uint64_t(i)));
    EXPECT_LE((CGP::spin(x(0), U) - squared_norm(x(0)) * V).norm(), 1e-14);
    const CGP::Block<Q> xV = CGP::Block<Q>::Constant(1, 1, x(0) * v);
    EXPECT_LE(norm(basis.project(xV)(0) - xV(0)), 1e-14);
  }
}

TEST(Reduced_basis, refuses_vectors_that_are_not_orthonormal)
{
  const Q one{1, 0, 0, 0}, i{0, 1, 0, 0}, zero{};
  EXPECT_NO_THROW(Basis(2, {1}, {{one, i}}));
  EXPECT_THROW(Basis(2, {1}, {{one, one}}), CGP::Precondition_error);
  EXPECT_THROW(Basis(2, {1}, {{one, zero}}), CGP::Precondition_error);
  EXPECT_THROW(Basis(2, {1}, {{zero, i}}), CGP::Precondition_error);
  EXPECT_THROW(Basis(2, {1}, {{one * 2., i}}), CGP::Precondition_error);
  EXPECT_THROW(Basis(2, {1}, {{one, i + one * 1e-9}}), CGP::Precondition_error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Basis(2, {1}, {{one, Q{0, nan, 0, 0}}}), CGP::Precondition_error);
}

TEST(Reduced_basis, names_the_row_whose_vectors_are_not_orthonormal)
{
  const Q one{1, 0, 0, 0}, i{0, 1, 0, 0};
  try {
    const Basis basis(9, {8, 5}, {{one, i}, {one, one}});
    FAIL();
  } catch (const CGP::Precondition_error& error) {
    EXPECT_NE(error.message().find("row 5 "), std::string::npos);
  }
}

TEST(Reduced_basis, refuses_another_number_of_planes_than_of_rows)
{
  EXPECT_THROW(Basis(3, {0, 1}, {}), CGP::Precondition_error);
}

}  // namespace cgp_test::reduced_basis_tests
