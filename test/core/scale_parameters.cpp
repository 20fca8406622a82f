// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/scale_parameters.h
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "support/cgal_meshes.h"
#include "support/limbs.h"

namespace cgp_test::scale_parameters_tests {

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

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

TEST(Scale_parameters, are_none_by_default)
{
  Mesh mesh = to_cgal_mesh<Mesh>(icosphere(1));
  auto rho = mesh.add_property_map<Mesh::Vertex_index, double>("v:rho", 0).first;
  const CGP::Spin_report report = CGP::spin_transform(mesh, rho);
  EXPECT_EQ(report.scales.bound, 0);
}

}  // namespace cgp_test::scale_parameters_tests
