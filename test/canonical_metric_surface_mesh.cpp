// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/canonical_metric.h
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <limits>

#include "canonical_metric_checks.h"

namespace cgp_test::canonical_metric_surface_mesh_tests {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

/// Returns the message of the exception, empty if there is none
std::string refusal(const Mesh_view& view)
{
  Surface mesh = to_cgal_mesh<Surface>(view);
  const auto density = mesh.add_property_map<Surface::Face_index, double>("f:u", -7).first;
  try {
    (void)CGP::canonical_metric(mesh, density);
  } catch (const CGP::Precondition_error& error) {
    for (const auto f : faces(mesh)) EXPECT_EQ(get(density, f), -7);
    EXPECT_EQ(error.function(), "canonical_metric");
    return error.message();
  }
  return "";
}

TEST(Canonical_metric_of_a_Surface_mesh, is_that_of_its_triangles)
{
  Surface mesh = to_cgal_mesh<Surface>(torus_to_measure());
  expect_canonical_metric(mesh, 1e-12);
}

TEST(Canonical_metric_of_a_Surface_mesh, reads_the_points_and_the_solver_that_are_passed)
{
  const double unit = 1e-30;
  Surface mesh = to_cgal_mesh<Surface>(torus_to_measure());
  const auto small = mesh.add_property_map<Surface::Vertex_index, Point>("v:small").first;
  for (const auto v : vertices(mesh)) {
    const Point p = mesh.point(v);
    put(small, v, Point(unit * p.x(), unit * p.y(), unit * p.z()));
  }
  const auto u = mesh.add_property_map<Surface::Face_index, double>("f:u").first;
  const auto w = mesh.add_property_map<Surface::Face_index, double>("f:w").first;
  (void)CGP::canonical_metric(mesh, u);
  const CGP::Canonical_metric_report report = CGP::canonical_metric(
      mesh, w,
      CGP::parameters::vertex_point_map(small).sparse_solver(CGP::Eigen_hermitian_solver_traits()));
  EXPECT_NEAR(report.area, 1, 1e-10);
  const Eigen::VectorXd scaled = unit * unit * values(faces(mesh), w);
  EXPECT_LT((scaled - values(faces(mesh), u)).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(Canonical_metric_of_a_Surface_mesh, refuses_what_has_none_and_writes_nothing)
{
  EXPECT_NE(refusal(icosphere(1)).find("genus 1 or more"), std::string::npos);
  EXPECT_NE(refusal(without_face(torus_to_measure(), 3)).find("boundary edge"), std::string::npos);
  EXPECT_EQ(refusal({Points(3, 0), {}}), "the mesh has no faces");
  Mesh_view broken = torus_to_measure();
  Points p = broken.positions();
  p(1, 5) = std::numeric_limits<double>::infinity();
  broken.set_positions(p);
  EXPECT_NE(refusal(broken).find("vertex 5"), std::string::npos);
}

}  // namespace cgp_test::canonical_metric_surface_mesh_tests
