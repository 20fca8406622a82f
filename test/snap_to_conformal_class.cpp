// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/snap_to_conformal_class.h
// Tests spin/snap_to_class.h
#include <Conformal_geometry_processing/snap_to_conformal_class.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <gtest/gtest.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <limits>

#include "support/cgal_meshes.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/tori.h"
#include "support/views.h"

namespace cgp_test::snap_to_conformal_class_tests {

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

template <class Mesh>
Points points_of(const Mesh& mesh)
{
  return CGP::Graph_view<Mesh>(mesh, CGP::parameters::default_values(), "test").view().positions();
}

/// a mesh, and a map with the points of a reference
template <class Mesh>
struct Case {
  Case(const Mesh_view& reference_view, const Points& f)
      : reference(reference_view),
        mesh(to_cgal_mesh<Mesh>({f, reference_view.corners()})),
        reference_points(get(CGAL::dynamic_vertex_property_t<Kernel::Point_3>(), mesh))
  {
    int i = 0;
    for (const auto v : vertices(mesh)) {
      const Eigen::Vector3d p = reference.position(i++);
      put(reference_points, v, Kernel::Point_3(p.x(), p.y(), p.z()));
    }
  }

  double change() const { return CGP::length_cross_ratio_change(reference, points_of(mesh)).max; }

  Mesh_view reference;
  Mesh mesh;
  typename boost::property_map<Mesh, CGAL::dynamic_vertex_property_t<Kernel::Point_3>>::type
      reference_points;
};

template <class Mesh>
void expect_exact_class(const Mesh_view& reference)
{
  const Points before = perturbed(reference, .03).positions();
  Case<Mesh> a(reference, before);
  const auto report = CGP::snap_to_conformal_class(a.mesh, a.reference_points);
  EXPECT_TRUE(report);
  EXPECT_GT(report.initial_length_cross_ratio.max, 1e-2);
  EXPECT_LT(report.length_cross_ratio.max, 1e-10);
  EXPECT_LT(a.change(), 1e-10);
  const Eigen::VectorXd moved = (points_of(a.mesh) - before).colwise().norm();
  const double diagonal = (before.rowwise().maxCoeff() - before.rowwise().minCoeff()).norm(),
               expected = std::sqrt(moved.squaredNorm() / static_cast<double>(moved.size()));
  EXPECT_GT(report.displacement, 1e-4);
  EXPECT_NEAR(report.displacement, expected / diagonal, 1e-12);
}

/// by the named parameter of spin transformations, on one mesh or each of its components
template <class Mesh>
void expect_exact_spin_transform(const Mesh_view& reference)
{
  namespace params = CGP::parameters;
  for (const bool by_components : {false, true}) {
    Case<Mesh> a(reference, reference.positions());
    const auto rho =
        boost::make_function_property_map<typename boost::graph_traits<Mesh>::vertex_descriptor,
                                          double>([&](auto v) {
          return .5 * std::sin(3 * CGAL::to_double(get(a.reference_points, v).y()));
        });
    const auto np = params::exact_conformal_class(true);
    EXPECT_TRUE(by_components ? bool(CGP::spin_transform_components(a.mesh, rho, np))
                              : bool(CGP::spin_transform(a.mesh, rho, np)));
    EXPECT_LT(a.change(), 1e-10);
    EXPECT_GT((points_of(a.mesh) - reference.positions()).norm(), .1);
  }
}

TEST(Snap_to_conformal_class, is_a_parameter_of_spin_transformations)
{
  for (const Mesh_view& mesh : {bumpy_sphere(2), torus(2, 1, 20, 10), disk(5)}) {
    expect_exact_spin_transform<Surface>(mesh);
    expect_exact_spin_transform<CGAL::Polyhedron_3<Kernel>>(mesh);
  }
}

TEST(Snap_to_conformal_class, keeps_length_cross_ratios_on_any_surface_and_any_mesh_type)
{
  for (const Mesh_view& mesh :
       {bumpy_sphere(2), irregular_torus(2, 1, 20, 10), disk(5), perturbed(icosphere(1), .3)}) {
    expect_exact_class<Surface>(mesh);
    expect_exact_class<CGAL::Polyhedron_3<Kernel>>(mesh);
  }
}

TEST(Snap_to_conformal_class, keeps_them_far_from_the_origin)
{
  const Mesh_view mesh = mapped(bumpy_sphere(2), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p + Eigen::Vector3d(300, -200, 100));
  });
  expect_exact_class<Surface>(mesh);
}

TEST(Snap_to_conformal_class, writes_to_the_output_map)
{
  const Mesh_view reference = bumpy_sphere(1);
  Case<Surface> a(reference, perturbed(reference, .03).positions());
  const Points before = points_of(a.mesh);
  auto output = get(CGAL::dynamic_vertex_property_t<Kernel::Point_3>(), a.mesh);
  EXPECT_TRUE(CGP::snap_to_conformal_class(a.mesh, a.reference_points,
                                           CGP::parameters::output_vertex_point_map(output)));
  EXPECT_EQ(points_of(a.mesh), before);
  EXPECT_NE(get(output, *vertices(a.mesh).begin()), a.mesh.point(*vertices(a.mesh).begin()));
}

TEST(Snap_to_conformal_class, writes_nothing_if_it_does_not_get_there)
{
  const Mesh_view reference = bumpy_sphere(1);
  Case<Surface> a(reference, perturbed(reference, .03).positions());
  const Points before = points_of(a.mesh);
  EXPECT_FALSE(CGP::snap_to_conformal_class(a.mesh, a.reference_points,
                                            CGP::parameters::number_of_iterations(1)));
  EXPECT_EQ(points_of(a.mesh), before);
}

TEST(Snap_to_conformal_class, refuses_edges_without_length_and_points_that_are_not_finite)
{
  const Mesh_view reference = bumpy_sphere(1);
  Points f = reference.positions();
  f.col(reference.ends(0)[1]) = f.col(reference.ends(0)[0]);
  Case<Surface> a(reference, f);
  EXPECT_THROW((void)CGP::snap_to_conformal_class(a.mesh, a.reference_points),
               CGP::Precondition_error);
  f.col(0).setConstant(std::numeric_limits<double>::quiet_NaN());
  Case<Surface> b(reference, f);
  EXPECT_THROW((void)CGP::snap_to_conformal_class(b.mesh, b.reference_points),
               CGP::Precondition_error);
}

}  // namespace cgp_test::snap_to_conformal_class_tests
