// Tests core/write_points.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/core/write_points.h>

#include <Eigen/Geometry>

#include <gtest/gtest.h>
#include <boost/math/quaternion.hpp>

#include <array>

namespace CGP = Conformal_geometry_processing;

namespace cgp_test::quaternion_access_tests {

struct Foreign {
  double real;
  Eigen::Vector3d rest;
};

}  // namespace cgp_test::quaternion_access_tests

template <>
struct CGP::Quaternion_access<cgp_test::quaternion_access_tests::Foreign> {
  using Foreign = cgp_test::quaternion_access_tests::Foreign;
  static CGP::Quaternion<double> from(const Foreign& f)
  {
    return {f.real, f.rest[0], f.rest[1], f.rest[2]};
  }
  static Foreign to(const CGP::Quaternion<double>& p) { return {p.w, {p.x, p.y, p.z}}; }
};

namespace cgp_test::quaternion_access_tests {

constexpr CGP::Quaternion<double> q{1, 2, 3, 4};

template <class Q>
void expect_round_trip()
{
  EXPECT_EQ(CGP::Quaternion_access<Q>::from(CGP::Quaternion_access<Q>::to(q)), q);
}

TEST(Quaternion_access, gives_back_what_it_wrote)
{
  expect_round_trip<CGP::Quaternion<double>>();
  expect_round_trip<CGP::Quaternion<float>>();
  expect_round_trip<Eigen::Quaterniond>();
  expect_round_trip<Eigen::Quaternionf>();
  expect_round_trip<boost::math::quaternion<double>>();
  expect_round_trip<boost::math::quaternion<float>>();
  expect_round_trip<std::array<double, 4>>();
  expect_round_trip<std::array<float, 4>>();
  expect_round_trip<Eigen::Vector4d>();
  expect_round_trip<Foreign>();
}

TEST(Quaternion_access, puts_the_real_part_where_each_type_has_it)
{
  const auto eigen = CGP::Quaternion_access<Eigen::Quaterniond>::to(q);
  EXPECT_EQ(eigen.w(), 1);
  EXPECT_EQ(eigen.z(), 4);
  const auto boost = CGP::Quaternion_access<boost::math::quaternion<double>>::to(q);
  EXPECT_EQ(boost.real(), 1);
  EXPECT_EQ(boost.R_component_4(), 4);
  const auto array = CGP::Quaternion_access<std::array<double, 4>>::to(q);
  EXPECT_EQ(array, (std::array<double, 4>{1, 2, 3, 4}));
}

TEST(Quaternion_access, keeps_the_hamilton_product_of_other_libraries)
{
  using Access = CGP::Quaternion_access<Eigen::Quaterniond>;
  const CGP::Quaternion<double> p{-2, 0.5, 1, 3};
  EXPECT_EQ(Access::from(Access::to(p) * Access::to(q)), p * q);
}

}  // namespace cgp_test::quaternion_access_tests
