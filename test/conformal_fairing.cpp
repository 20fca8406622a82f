// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_fairing.h
#include <Conformal_geometry_processing/conformal_fairing.h>

#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>
#include <vector>

#include "support/cgal_meshes.h"
#include "support/meshes.h"
#include "support/views.h"

namespace cgp_test::conformal_fairing_tests {

namespace CGP = Conformal_geometry_processing;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

template <class Mesh>
auto faces_where(const Mesh& mesh, bool (*is_inside)(const Kernel::Point_3&))
{
  std::vector<typename boost::graph_traits<Mesh>::face_descriptor> found;
  const auto points = get(CGAL::vertex_point, mesh);
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const auto c = CGAL::centroid(get(points, source(h, mesh)), get(points, target(h, mesh)),
                                  get(points, target(next(h, mesh), mesh)));
    if (is_inside(c)) found.push_back(f);
  }
  return found;
}

bool is_high(const Kernel::Point_3& p)
{
  return p.z() > .3;
}

/// a sphere with a dent
template <class Mesh>
Mesh dented_sphere()
{
  return to_cgal_mesh<Mesh>(mapped(geodesic_sphere(12), [](const Eigen::Vector3d& p) {
    const double d = (std::max)(0., p.z() - .45);
    return Eigen::Vector3d(p.x(), p.y(), p.z() - 2 * d * d);
  }));
}

double distance_from_unit_sphere(const Points& f)
{
  return (f.colwise().norm().array() - 1).abs().maxCoeff();
}

const auto outline = CGP::parameters::exact_conformal_class(false);

template <class Mesh>
void expect_no_dent()
{
  Mesh mesh = dented_sphere<Mesh>();
  EXPECT_GT(distance_from_unit_sphere(view_of(mesh).positions()), .3);
  EXPECT_TRUE(CGP::conformal_fairing(mesh, faces_where(mesh, is_high), outline));
  EXPECT_LT(distance_from_unit_sphere(view_of(mesh).positions()), 1e-2);
}

TEST(Conformal_fairing, takes_a_dent_out_of_any_mesh_type)
{
  expect_no_dent<Surface>();
  expect_no_dent<Polyhedron>();
}

TEST(Conformal_fairing, fairs_a_hole_that_cgal_has_filled)
{
  for (const int frequency : {8, 16}) {
    Surface mesh = to_cgal_mesh<Surface>(geodesic_sphere(frequency));
    for (const auto f : faces_where(mesh, is_high))
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
    std::vector<Surface::Face_index> filled;
    for (const auto h : halfedges(mesh))
      if (is_border(h, mesh)) {
        PMP::triangulate_and_refine_hole(mesh, h, std::back_inserter(filled),
                                         CGAL::Emptyset_iterator());
        break;
      }
    ASSERT_GT(filled.size(), 50u);
    const auto report = CGP::conformal_fairing(mesh, filled, outline);
    EXPECT_TRUE(report);
    EXPECT_GT(report.initial_normal_jump.rms, .5);
    EXPECT_LT(report.normal_jump.rms, 1.5 / frequency);
    EXPECT_LT(distance_from_unit_sphere(view_of(mesh).positions()), 2. / frequency / frequency);
  }
}

TEST(Conformal_fairing, keeps_length_cross_ratios_by_default)
{
  Surface mesh = to_cgal_mesh<Surface>(mapped(geodesic_sphere(10), [](const Eigen::Vector3d& p) {
    const double d = (std::max)(0., p.z() - .45);
    return Eigen::Vector3d(1.5 * p.x(), p.y(), p.z() - d * d);
  }));
  const Mesh_view before = view_of(mesh);
  const auto report = CGP::conformal_fairing(mesh, faces_where(mesh, is_high));
  EXPECT_GT(report.steps, 0);
  EXPECT_LT(report.energy, report.initial_energy);
  EXPECT_LT(CGP::length_cross_ratio_change(before, view_of(mesh).positions()).max, 1e-8);
}

TEST(Conformal_fairing, writes_all_points_to_the_output_map)
{
  Surface mesh = dented_sphere<Surface>();
  const Points before = view_of(mesh).positions();
  auto output = get(CGAL::dynamic_vertex_property_t<Kernel::Point_3>(), mesh);
  EXPECT_TRUE(CGP::conformal_fairing(mesh, faces_where(mesh, is_high),
                                     outline.output_vertex_point_map(output)));
  EXPECT_EQ(view_of(mesh).positions(), before);
  int kept = 0, moved = 0;
  for (const auto v : vertices(mesh)) (get(output, v) == mesh.point(v) ? kept : moved) += 1;
  EXPECT_GT(kept, 100);
  EXPECT_GT(moved, 100);
}

TEST(Conformal_fairing, asks_its_visitor_and_stops)
{
  struct Impatient : CGP::Flow_visitor {
    bool go_further() { return ++asked < 3; }
    int asked = 0;
  } visitor;
  Surface mesh = dented_sphere<Surface>();
  const auto report = CGP::conformal_fairing(mesh, faces_where(mesh, is_high),
                                             outline.tolerance(1e-9).visitor(std::ref(visitor)));
  EXPECT_FALSE(report);
  EXPECT_EQ(report.steps, 2);
  EXPECT_EQ(report.message, "cancelled");
}

TEST(Conformal_fairing, leaves_the_mesh_as_it_is_if_the_visitor_throws)
{
  struct Thrower : CGP::Flow_visitor {
    bool go_further() { throw std::runtime_error("no"); }
  } visitor;
  Surface mesh = dented_sphere<Surface>();
  const Points before = view_of(mesh).positions();
  EXPECT_THROW((void)CGP::conformal_fairing(mesh, faces_where(mesh, is_high),
                                            outline.visitor(std::ref(visitor))),
               std::runtime_error);
  EXPECT_EQ(view_of(mesh).positions(), before);
}

TEST(Conformal_fairing, refuses_faces_of_another_mesh_and_tolerances_that_are_not_positive)
{
  Surface mesh = dented_sphere<Surface>();
  auto region = faces_where(mesh, is_high);
  EXPECT_THROW((void)CGP::conformal_fairing(mesh, region, CGP::parameters::tolerance(0)),
               CGP::Precondition_error);
  region.push_back(Surface::Face_index(static_cast<unsigned>(num_faces(mesh) + 3)));
  EXPECT_THROW((void)CGP::conformal_fairing(mesh, region), CGP::Precondition_error);
  region.clear();
  EXPECT_THROW((void)CGP::conformal_fairing(mesh, region), CGP::Precondition_error);
}

}  // namespace cgp_test::conformal_fairing_tests
