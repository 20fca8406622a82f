// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_deformation.h core/spin_parameters.h
#include <Conformal_geometry_processing/conformal_deformation.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "support/cgal_meshes.h"
#include "support/control_points.h"
#include "support/limbs.h"

namespace cgp_test::conformal_deformation_tests {

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Vertex = Surface::Vertex_index;
using Targets = std::vector<std::pair<Vertex, Point>>;
using Motion = CGAL::Aff_transformation_3<Kernel>;
using Regions = std::vector<std::pair<std::vector<Vertex>, Motion>>;

Point point(const Eigen::Vector3d& p)
{
  return {p.x(), p.y(), p.z()};
}

/// one vertex of seven is moved
Targets targets(const Mesh_view& mesh, double radii)
{
  Targets all;
  for (const auto& p : one_moved(mesh, 7, radii))
    all.emplace_back(Vertex(static_cast<unsigned>(p.vertices[0])), point(p.target));
  return all;
}

template <class TargetRange>
std::string complaint(const TargetRange& all)
{
  Surface mesh = to_cgal_mesh<Surface>(dumbbell(1));
  const std::vector<Point> before(mesh.points().begin(), mesh.points().end());
  std::string what;
  try {
    EXPECT_FALSE(CGP::conformal_deformation(mesh, all));
  } catch (const CGP::Precondition_error& error) {
    what = error.what();
  }
  EXPECT_TRUE(std::equal(before.begin(), before.end(), mesh.points().begin()));
  return what;
}

bool has(const std::string& text, const char* words)
{
  return text.find(words) != std::string::npos;
}

TEST(Conformal_deformation_of_a_mesh, moves_vertices_to_their_targets)
{
  const Mesh_view view = dumbbell(3);
  Surface mesh = to_cgal_mesh<Surface>(view);
  const Targets all = targets(view, .3);
  const CGP::Spin_report report = CGP::conformal_deformation(mesh, all);
  EXPECT_TRUE(report) << to_string(report.fault());
  for (const auto& [v, p] : all)
    EXPECT_LT(CGAL::squared_distance(mesh.point(v), p), 1e-16 * diagonal(view) * diagonal(view));
}

TEST(Conformal_deformation_of_a_mesh, takes_named_parameters)
{
  const Mesh_view view = dumbbell(3);
  Surface mesh = to_cgal_mesh<Surface>(view);
  auto output = mesh.add_property_map<Vertex, Point>("v:moved").first;
  auto spins = mesh.add_property_map<Vertex, CGP::Quaternion<double>>("v:lambda").first;
  const CGP::Spin_report report =
      CGP::conformal_deformation(mesh, targets(view, .2),
                                 CGP::parameters::output_vertex_point_map(output)
                                     .vertex_spin_map(spins)
                                     .position_weight(30.)
                                     .scale_bound(1.5));
  EXPECT_TRUE(report);
  EXPECT_GT(report.position_error.max, 1e-5);
  EXPECT_EQ(report.scales.bound, 1.5);
  const Vertex v(7);
  EXPECT_EQ(mesh.point(v), point(view.position(7)));
  EXPECT_GT(CGAL::squared_distance(mesh.point(v), output[v]), 0);
  EXPECT_GT(squared_norm(spins[v]), .1);
}

TEST(Conformal_deformation_of_a_mesh, changes_nothing_outside_of_a_region)
{
  const Mesh_view view = dumbbell(3);
  Surface mesh = to_cgal_mesh<Surface>(view);
  int top;
  view.positions().row(1).maxCoeff(&top);
  auto weights = mesh.add_property_map<Vertex, double>("v:region").first;
  for (const Vertex v : mesh.vertices())
    weights[v] = (std::min)(1., (std::max)(0., mesh.point(v).y()));
  const Vertex moved(static_cast<unsigned>(top));
  const Point target = mesh.point(moved) + Kernel::Vector_3(.2, .1, 0);
  const CGP::Spin_report report = CGP::conformal_deformation(
      mesh, Targets{{moved, target}}, CGP::parameters::vertex_region_map(weights));
  ASSERT_TRUE(report);
  ASSERT_TRUE(report.collar);
  EXPECT_GT(report.collar->quasi_conformal.max, 1);
  EXPECT_LT(CGAL::squared_distance(mesh.point(moved), target), 1e-16);
  for (int v = 0; v < view.size_of_vertices(); ++v) {
    const Point now = mesh.point(Vertex(static_cast<unsigned>(v)));
    EXPECT_TRUE(view.position(v).y() > 0 || now == point(view.position(v))) << v;
  }
}

TEST(Conformal_deformation_of_a_mesh, moves_regions)
{
  const Mesh_view view = dumbbell(3);
  Surface mesh = to_cgal_mesh<Surface>(view);
  Regions all = {{{}, Motion(CGAL::IDENTITY)},
                 {{}, Motion(CGAL::TRANSLATION, Kernel::Vector_3(.2, .3, 0))}};
  for (const Vertex v : vertices(mesh))
    if (std::abs(mesh.point(v).y()) > 1.5) all[mesh.point(v).y() > 0].first.push_back(v);
  const auto centre = [&](const std::vector<Vertex>& region) {
    Kernel::Vector_3 sum(0, 0, 0);
    for (const Vertex v : region) sum += mesh.point(v) - CGAL::ORIGIN;
    return sum / double(region.size());
  };
  const auto apart = centre(all[1].first) - centre(all[0].first);
  EXPECT_TRUE(CGP::conformal_deformation(mesh, all));
  const auto now = centre(all[1].first) - centre(all[0].first);
  EXPECT_LT((now - apart - Kernel::Vector_3(.2, .3, 0)).squared_length(), .02 * .02);
}

TEST(Conformal_deformation_of_a_mesh, refuses_and_leaves_the_mesh_alone)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Point p(0, 0, 0), q(1, 1, 1);
  EXPECT_TRUE(has(complaint(Targets()), "no targets"));
  EXPECT_TRUE(
      has(complaint(Targets{{Vertex(0), p}, {Vertex(999), q}}), "target 1 is for no vertex"));
  EXPECT_TRUE(has(complaint(Targets{{Vertex(1), p}, {Vertex(1), q}}), "as is target 0"));
  EXPECT_TRUE(has(complaint(Targets{{Vertex(1), Point(0, nan, 0)}}), "not finite"));
  EXPECT_TRUE(has(complaint(Targets{{Vertex(1), p}, {Vertex(2), p}}), "at one place"));
  EXPECT_TRUE(has(complaint(Regions{{{}, Motion(CGAL::IDENTITY)}}), "target 0 has no vertices"));
  EXPECT_EQ(complaint(targets(dumbbell(1), 8)), "");  // out of reach
}

TEST(Conformal_deformation_of_a_mesh, takes_a_polyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Mesh_view view = dumbbell(1);
  Polyhedron mesh = to_cgal_mesh<Polyhedron>(view);
  const std::vector<boost::graph_traits<Polyhedron>::vertex_descriptor> all(vertices(mesh).begin(),
                                                                            vertices(mesh).end());
  const Point to(5, 6, 7);
  const std::vector<std::pair<decltype(all)::value_type, Point>> one = {{all[3], to}};
  EXPECT_TRUE(CGP::conformal_deformation(mesh, one));
  EXPECT_LT(CGAL::squared_distance(all[3]->point(), to), 1e-20);
}

}  // namespace cgp_test::conformal_deformation_tests
