// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin_transform.h, conformal_willmore_flow.h
// Tests conformal_parameterization.h

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "components_checks.h"

namespace cgp_test::components_refusals_tests {

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

int tries = 0;

/// a solver without memory
template <class Scalar>
struct Solver_without_memory : CGP::Supernodal_cholesky<Scalar> {
  CGP::Solver_status factorize(const CGP::Hermitian_sparse_matrix<Scalar>&, const Eigen::VectorXd&)
  {
    ++tries;
    return CGP::Solver_status::out_of_memory;
  }
};
struct Solver_traits_without_memory {
  template <class Scalar>
  using Solver = Solver_without_memory<Scalar>;
};

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
            "each): component 0 (from vertex 0): the surface is closed; no boundary can be "
            "prescribed");
  EXPECT_EQ(refusal([&] {
              std::map<Vertex, std::complex<double>> uv;
              (void)CGP::conformal_parameterization_components(mesh,
                                                               boost::make_assoc_property_map(uv));
            }),
            "conformal_parameterization_components: 1 of 2 components failed (their elements are "
            "counted in each): component 0 (from vertex 0): the surface is closed; one with a "
            "boundary is needed, cut it open");
}

TEST(Components_that_fail_alike, are_counted_and_the_first_are_named)
{
  Surface mesh = to_cgal_mesh<Surface>(interleaved(std::vector<Mesh_view>(7, tetrahedron())).mesh);
  try {
    (void)CGP::conformal_willmore_flow_components(mesh, params::time_step(-1.));
    FAIL();
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(error.message().rfind("7 of 7 components failed (their elements are counted in each):"
                                    " component 0 (from vertex 0), component 1 (from vertex 1), ",
                                    0),
              0u);
    const std::size_t reason = error.message().find(" and 2 more: ");
    ASSERT_NE(reason, std::string::npos);
    EXPECT_EQ(error.message().find("component", reason), std::string::npos);
  }
}

TEST(Components_that_fail_for_lack_of_memory, are_the_last_ones_tried)
{
  const Surface mesh = to_cgal_mesh<Surface>(interleaved({disk(2), disk(2)}).mesh);
  std::map<Vertex, std::complex<double>> uv;
  tries = 0;
  try {
    (void)CGP::conformal_parameterization_components(
        mesh, boost::make_assoc_property_map(uv),
        params::sparse_solver(Solver_traits_without_memory()));
    FAIL();
  } catch (const CGP::Solver_error& error) {
    EXPECT_TRUE(CGP::is_out_of_memory(error)) << error.what();
  }
  EXPECT_EQ(tries, 1);
  EXPECT_TRUE(uv.empty());
}

TEST_F(Components_that_fail, with_mollification_are_named_with_the_reason)
{
  const auto none = map_of([](Vertex) { return 0.; });
  for (const double share : {0., 1.})
    EXPECT_NE(refusal([&] {
                (void)CGP::spin_transform_components(mesh, none, params::mollification(share));
              }).find("component 0 (from vertex 0), component 1 (from vertex 1): a mollification"),
              std::string::npos)
        << share;
  Points line = Points::Zero(3, 4);
  line.row(0) << 0, 1, 2, 3;
  const Joined_meshes two = interleaved({icosahedron(), {line, {{0, 1, 2}, {0, 2, 3}}}});
  Surface surface = to_cgal_mesh<Surface>(two.mesh);
  try {
    (void)CGP::spin_transform_components(surface, none, params::mollification(1e-6));
    FAIL();
  } catch (const CGP::Precondition_error& error) {
    EXPECT_NE(error.message().find("1 of 2 components"), std::string::npos) << error.what();
    EXPECT_NE(error.message().find("component 1 (from vertex 1): "), std::string::npos);
    EXPECT_NE(error.message().find("all faces have area zero"), std::string::npos) << error.what();
  }
  EXPECT_EQ(view_of(surface).positions(), two.mesh.positions());
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
  const auto reports = CGP::spin_transform_components(mesh, map_of(rho_of_sphere),
                                                      unbounded().number_of_iterations(1u));
  EXPECT_FALSE(reports);
  ASSERT_EQ(reports.components.size(), 2u);
  EXPECT_FALSE(reports.components[0].report);
  EXPECT_TRUE(reports.components[1].report);
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

}  // namespace cgp_test::components_refusals_tests
