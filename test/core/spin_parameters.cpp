// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_deformation.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <optional>
#include <utility>
#include <vector>

#include "support/cgal_meshes.h"
#include "support/control_points.h"
#include "support/limbs.h"
#include "support/views.h"

namespace cgp_test::spin_parameters_tests {

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
namespace params = CGP::parameters;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

TEST(Scale_parameters, reach_the_transformation)
{
  const Mesh_view view = dumbbell(3);
  const Eigen::VectorXd values = rings(view, 2, 3);
  Mesh mesh = to_cgal_mesh<Mesh>(view);
  auto rho = mesh.add_property_map<Mesh::Vertex_index, double>("v:rho").first;
  auto weight = mesh.add_property_map<Mesh::Vertex_index, double>("v:weight", 1).first;
  auto factor = mesh.add_property_map<Mesh::Vertex_index, double>("v:factor", 3).first;
  for (const auto v : vertices(mesh)) rho[v] = values[v.idx()];
  const CGP::Spin_report report = CGP::spin_transform(
      mesh, rho,
      CGP::parameters::scale_bound(1.5).vertex_scale_weight_map(weight).vertex_scale_map(factor));
  EXPECT_TRUE(report);
  EXPECT_EQ(report.scales.bound, 1.5);
  EXPECT_GT(report.scales.weight, 0);
  CGP::Spin_transformation_options options;
  options.scales.bound = 1.5;  // equal weights and factors are none
  CGP::Spin_transformation transformation(view, options);
  const auto same = transformation.transform(CGP::Curvature_potential::on_vertices(values));
  EXPECT_NEAR(same.report.scales.kept_norm, report.scales.kept_norm, 1e-6);
}

/// a surface, and what is done to it
struct Found {
  CGP::Spin_report report;
  Points positions;

  bool operator==(const Found& other) const
  {
    return positions == other.positions && report.scales.bound == other.report.scales.bound;
  }
};

/// a surface on whose limbs a transformation without a bound would scale lengths by more than 2
class Scale_bound : public testing::Test {
 protected:
  template <class NamedParameters = params::Default_named_parameters>
  Found spun(const NamedParameters& np = params::default_values()) const
  {
    Mesh mesh = original;
    const auto rho = boost::make_function_property_map<Vertex>(
        [this](Vertex v) { return values[static_cast<Eigen::Index>(v)]; });
    const CGP::Spin_report report = CGP::spin_transform(mesh, rho, np);
    return {report, view_of(mesh).positions()};
  }

  template <class NamedParameters = params::Default_named_parameters>
  Found deformed(const NamedParameters& np = params::default_values()) const
  {
    Mesh mesh = original;
    std::vector<std::pair<Vertex, Point>> targets;
    for (const auto& p : one_moved(view, 7, .2))
      targets.emplace_back(Vertex(static_cast<unsigned>(p.vertices[0])),
                           Point(p.target.x(), p.target.y(), p.target.z()));
    const CGP::Spin_report report = CGP::conformal_deformation(mesh, targets, np);
    return {report, view_of(mesh).positions()};
  }

  const Mesh original = to_cgal_mesh<Mesh>(dumbbell(3));
  const Mesh_view view = view_of(original);
  Eigen::VectorXd values = rings(view, 4, 3);
  const boost::static_property_map<double, Vertex> factor{3};
};

TEST_F(Scale_bound, is_two_unless_another_one_is_given)
{
  const Found usual = spun();
  EXPECT_EQ(usual.report.scales.bound, 2);
  EXPECT_GT(usual.report.scales.weight, 0);
  EXPECT_EQ(usual, spun(params::scale_bound(2)));
  EXPECT_EQ(deformed(), deformed(params::scale_bound(2.)));
}

TEST_F(Scale_bound, is_smaller_about_wanted_factors)
{
  EXPECT_EQ(spun(params::vertex_scale_map(factor)),
            spun(params::vertex_scale_map(factor).scale_bound(1.25)));
  EXPECT_EQ(deformed(params::vertex_scale_map(factor)),
            deformed(params::vertex_scale_map(factor).scale_bound(1.25)));
}

TEST_F(Scale_bound, can_be_none)
{
  values *= .1;
  const Found plain = spun(params::scale_bound(std::nullopt));
  ASSERT_TRUE(plain.report);
  EXPECT_FALSE(plain.report.is_relaxed);
  EXPECT_EQ(plain.report.scales.bound, 0);
  const CGP::Spin_result eigenvector =
      CGP::Spin_transformation(view).transform(CGP::Curvature_potential::on_vertices(values));
  EXPECT_TRUE(plain.positions == eigenvector.positions);
  EXPECT_EQ(plain.report.eigenvalue, eigenvector.report.eigenvalue);
  EXPECT_EQ(deformed(params::scale_bound(std::nullopt)).report.scales.bound, 0);
}

TEST_F(Scale_bound, has_to_be_there_for_factors_and_weights)
{
  const auto np = params::scale_bound(std::nullopt);
  EXPECT_THROW((void)spun(np.vertex_scale_map(factor)), CGP::Precondition_error);
  EXPECT_THROW((void)spun(np.vertex_scale_weight_map(factor)), CGP::Precondition_error);
}

TEST(Scale_bound_of_a_prescribed_boundary, is_none_by_default)
{
  CGP::Spin_transformation_options options;
  const auto by_default = [&](CGP::Boundary_condition condition) {
    options.boundary = std::move(condition);
    return CGP::internal::default_bound(options);
  };
  const Points targets = Points::Ones(3, 2);
  EXPECT_EQ(by_default(CGP::Boundary_condition::free()), 2);
  EXPECT_EQ(by_default(CGP::Boundary_condition::tangents()), 2);
  EXPECT_EQ(by_default(CGP::Boundary_condition::tangents(targets)), std::nullopt);
  EXPECT_EQ(by_default(CGP::Boundary_condition::positions(targets, targets)), std::nullopt);
}

}  // namespace cgp_test::spin_parameters_tests
