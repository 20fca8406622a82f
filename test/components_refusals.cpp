// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin_transform_components.h, conformal_willmore_flow_components.h
// Tests conformal_parameterization_components.h
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <functional>
#include <limits>
#include <string>

#include "components_checks.h"

namespace {

using namespace cgp_test;
namespace params = CGP::parameters;
using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Surface::Vertex_index;
using Function = std::function<double(Vertex)>;

boost::function_property_map<Function, Vertex> map_of(Function function)
{
  return boost::function_property_map<Function, Vertex>(std::move(function));
}

/// a sphere, whose vertices have even numbers as long as the disk has some, and a disk
class Components_that_fail : public testing::Test {
 protected:
  void expect_untouched() const { EXPECT_EQ(view_of(mesh).positions(), before.positions()); }

  template <class Work>
  std::string refusal(const Work& work) const
  {
    try {
      work();
    } catch (const CGP::Precondition_error& error) {
      expect_untouched();
      return error.what();
    }
    return "";
  }

  const Joined_meshes all = interleaved({icosphere(1), moved(disk(3), {0, 0, 5})});
  Surface mesh = to_cgal_mesh<Surface>(all.mesh);
  const Mesh_view before = view_of(mesh);
  const Function rho = [this](Vertex v) { return rho_at(before.position(static_cast<int>(v))); };
};

struct Visitor_that_cancels : CGP::Spin_visitor {
  int iterations = 0;
  void on_iteration(const CGP::Eigen_progress&) { ++iterations; }
  bool go_further() const { return false; }
};

}  // namespace

TEST_F(Components_that_fail, are_refused_where_one_is_wanted)
{
  EXPECT_THROW((void)CGP::spin_transform(mesh, map_of(rho)), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::conformal_willmore_flow(mesh), CGP::Precondition_error);
  expect_untouched();
}

TEST_F(Components_that_fail, are_named_with_the_reason)
{
  EXPECT_EQ(refusal([&] {
              (void)CGP::spin_transform_components(
                  mesh, map_of(rho), params::boundary_direction(CGP::Boundary_direction{0, 0, 1}));
            }),
            "spin_transform_components: 1 of 2 components failed (their elements are counted in "
            "each): component 0, from vertex 0: the surface is closed; no boundary can be "
            "prescribed");
  EXPECT_EQ(refusal([&] {
              std::map<Vertex, std::complex<double>> uv;
              (void)CGP::conformal_parameterization_components(mesh,
                                                               boost::make_assoc_property_map(uv));
            }),
            "conformal_parameterization_components: 1 of 2 components failed (their elements are "
            "counted in each): component 0, from vertex 0: the surface is closed; one with a "
            "boundary is needed, cut it open");
  EXPECT_NE(refusal([&] {
              (void)CGP::conformal_willmore_flow_components(mesh, params::time_step(-1.));
            }).find("2 of 2 components failed"),
            std::string::npos);
}

TEST_F(Components_that_fail, for_their_elements_name_them_as_those_of_the_mesh)
{
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([&] {
              (void)CGP::spin_transform_components(
                  mesh, map_of([&](Vertex v) { return v == Vertex(41) ? not_a_number : 0.; }));
            }),
            "spin_transform_components: 1 value of rho not finite, the first is vertex 41; finite "
            "values are needed");
  const Mesh_view two = disjoint_union(icosahedron(), tetrahedron(), {9, 0, 0});
  Points points = two.positions();
  points.col(12) = points.col(13);
  Surface flat = to_cgal_mesh<Surface>({points, two.corners()});
  const auto complaint = [&](const auto& work) -> std::string {
    try {
      work();
    } catch (const CGP::Precondition_error& error) {
      return error.message();
    }
    return "";
  };
  const auto none = map_of([](Vertex) { return 0.; });
  for (const std::string& message :
       {complaint([&] { (void)CGP::spin_transform_components(flat, none); }),
        complaint([&] { (void)CGP::conformal_willmore_flow_components(flat); })})
    EXPECT_NE(message.find("2 faces of area zero, the first is face 20 (vertices"),
              std::string::npos)
        << message;
}

TEST_F(Components_that_fail, to_converge_leave_the_others_as_they_were_too)
{
  const Function rho_of_sphere = [this](Vertex v) {
    return before.position(static_cast<int>(v)).z() > 4 ? 0 : 3 * rho(v);
  };
  const auto reports =
      CGP::spin_transform_components(mesh, map_of(rho_of_sphere), params::number_of_iterations(1u));
  EXPECT_FALSE(reports);
  ASSERT_EQ(reports.components.size(), 2u);
  EXPECT_FALSE(reports.components[0].report);
  EXPECT_TRUE(reports.components[1].report);
  expect_untouched();
}

TEST_F(Components_that_fail, because_they_are_cancelled_are_not_begun)
{
  Visitor_that_cancels visitor;
  const auto reports =
      CGP::spin_transform_components(mesh, map_of(rho), params::visitor(std::ref(visitor)));
  EXPECT_FALSE(reports);
  EXPECT_TRUE(reports.components[0].report.cancelled);
  EXPECT_TRUE(reports.components[1].report.cancelled);
  EXPECT_EQ(visitor.iterations, 1);
  expect_untouched();
}

TEST(Components_of_a_mesh_with_garbage, are_those_of_its_triangles)
{
  Surface mesh;
  add_to_cgal_mesh(tetrahedron(), mesh);
  const std::vector<Surface::Face_index> first(faces(mesh).begin(), faces(mesh).end());
  const std::vector<Mesh_view> parts = {icosphere(1), moved(icosahedron(), {5, 0, 0})};
  const Joined_meshes all = interleaved(parts);
  add_to_cgal_mesh(all.mesh, mesh);
  for (const auto f : first) CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  ASSERT_TRUE(CGP::spin_transform_components(mesh, rho_map(mesh)));
  for (std::size_t p = 0; p < 2; ++p) {
    Surface alone = to_cgal_mesh<Surface>(parts[p]);
    ASSERT_TRUE(CGP::spin_transform(alone, rho_map(alone)));
    EXPECT_EQ(columns(view_of(mesh).positions(), all.vertices[p]), view_of(alone).positions());
  }
}
