// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/moebius_transform.h
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <limits>

#include "moebius_transform_checks.h"

namespace cgp_test::moebius_transform_surface_mesh_tests {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

/// Returns the message of the exception, empty if there is none; checks that nothing is written
template <class Transform>
std::string refusal(const Mesh_view& view, Transform transform)
{
  Surface mesh = to_cgal_mesh<Surface>(view);
  try {
    transform(mesh);
  } catch (const CGP::Precondition_error& error) {
    for (const auto v : vertices(mesh))
      EXPECT_EQ(mesh.point(v).x(), view.position(static_cast<int>(v.idx())).x());
    return error.what();
  }
  return "";
}

double volume(const Mesh_view& mesh, const Surface& moved)
{
  return CGP::signed_volume({points_of(moved), mesh.corners()});
}

TEST(Moebius_transform_of_a_Surface_mesh, moves_each_vertex_by_the_map)
{
  expect_moebius_transforms(to_cgal_mesh<Surface>(sphere_to_invert()), 1e-13);
}

TEST(Moebius_transform_of_a_Surface_mesh, reads_and_writes_the_maps_that_are_passed)
{
  Surface mesh = to_cgal_mesh<Surface>(sphere_to_invert());
  const auto in = mesh.add_property_map<Surface::Vertex_index, Point>("v:in").first;
  const auto out = mesh.add_property_map<Surface::Vertex_index, Point>("v:out").first;
  for (const auto v : vertices(mesh)) put(in, v, Point(mesh.point(v).x(), 2, 3));
  (void)CGP::moebius_transform(mesh, CGP::Moebius_map::translation({0, 0, 1}),
                               CGP::parameters::vertex_point_map(in).output_vertex_point_map(out));
  for (const auto v : vertices(mesh)) EXPECT_EQ(get(out, v), Point(mesh.point(v).x(), 2, 4));
  EXPECT_EQ(points_of(mesh), sphere_to_invert().positions());
}

TEST(Moebius_transform_of_a_Surface_mesh, of_nothing_is_nothing)
{
  Surface mesh;
  EXPECT_EQ(CGP::moebius_transform(mesh, CGP::Moebius_map::inversion()).max_length_scale, 0);
}

TEST(Invert_in_sphere, keeps_the_outside_out_unless_the_center_is_inside)
{
  const Mesh_view sphere = icosphere(3);
  Surface mesh = to_cgal_mesh<Surface>(sphere);
  (void)CGP::invert_in_sphere(mesh, Point(0, 3, 0), 2);
  EXPECT_GT(volume(sphere, mesh), 0);
  mesh = to_cgal_mesh<Surface>(sphere);
  (void)CGP::invert_in_sphere(mesh, Point(0, .3, 0), 2);
  EXPECT_LT(volume(sphere, mesh), 0);
}

TEST(Invert_in_sphere, twice_is_the_identity_also_far_from_the_origin)
{
  const Mesh_view mesh = mapped(bumpy_sphere(2), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p + Eigen::Vector3d(1e6, -2e6, 3e6));
  });
  Surface moved = to_cgal_mesh<Surface>(mesh);
  const CGP::internal::Moebius_report report =
      CGP::invert_in_sphere(moved, Point(1e6, -2e6 + 3, 3e6), 2);
  EXPECT_LT(CGP::length_cross_ratio_change(mesh, points_of(moved)).max, 1e-7);
  EXPECT_GT(report.min_length_scale, 4. / (4.5 * 4.5));
  EXPECT_LT(report.max_length_scale, 4. / (1.5 * 1.5));
  (void)CGP::invert_in_sphere(moved, Point(1e6, -2e6 + 3, 3e6), 2);
  EXPECT_LT(greatest_distance(points_of(moved), mesh.positions()), 1e-8);
}

TEST(Moebius_transform, refuses_vertices_that_go_to_infinity_or_are_not_finite)
{
  const auto invert = [](Surface& m) {
    (void)CGP::moebius_transform(m, CGP::Moebius_map::inversion());
  };
  Mesh_view mesh = icosphere(0);
  EXPECT_EQ(refusal(mesh, invert), "");
  Points p = mesh.positions();
  p.col(5).setZero();
  mesh.set_positions(p);
  const std::string wanted = "goes to infinity or is not finite; the map must send no point there";
  EXPECT_EQ(refusal(mesh, invert), "moebius_transform: point 5 " + wanted);
  p = icosphere(0).positions();
  p(2, 7) = std::numeric_limits<double>::infinity();
  mesh.set_positions(p);
  EXPECT_EQ(refusal(mesh, invert), "moebius_transform: point 7 " + wanted);
}

TEST(Invert_in_sphere, refuses_a_center_on_a_vertex_and_a_radius_that_is_none)
{
  const Mesh_view mesh = icosphere(0);
  const Eigen::Vector3d v = mesh.position(3);
  const auto invert = [](const Point& center, double radius) {
    return [=](Surface& m) { (void)CGP::invert_in_sphere(m, center, radius); };
  };
  EXPECT_NE(refusal(mesh, invert(Point(v.x(), v.y(), v.z()), 1)).find("point 3 goes to infinity"),
            std::string::npos);
  EXPECT_EQ(refusal(mesh, invert(Point(0, 0, 0), -1)),
            "invert_in_sphere: the center must be finite, and the radius, -1.000000, positive");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal(mesh, invert(Point(0, 0, 0), infinity)), "");
  EXPECT_NE(refusal(mesh, invert(Point(infinity, 0, 0), 1)), "");
}

}  // namespace cgp_test::moebius_transform_surface_mesh_tests
