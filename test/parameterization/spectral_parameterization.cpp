// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "flat_maps.h"
#include "support/decompositions.h"
#include "support/meshes.h"

namespace cgp_test::spectral_parameterization_tests {

namespace CGP = Conformal_geometry_processing;
using Normals = CGP::Parameterization_options::Normals;

CGP::internal::Parameterization_result flattened(const Mesh_view& mesh,
                                                 Normals normals = Normals::of_faces)
{
  CGP::Parameterization_options options;
  options.normals = normals;
  options.tolerance = 1e-8;
  return CGP::spectral_parameterization(mesh, options);
}

/// \brief Computes the smallest eigenvalues by definition: minimal |C z|^2 over the variance of the
/// boundary, for all maps with mean zero on the boundary; the interior is eliminated.
Eigen::VectorXd eigenvalues_by_definition(const Mesh_view& mesh)
{
  const Eigen::MatrixXd C = least_squares_conformal_rows(mesh), A = C.transpose() * C;
  const CGP::internal::Vertex_loop loop = CGP::boundary_loops(mesh)[0];
  std::vector<int> outside, inside;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    auto& rows = std::find(loop.begin(), loop.end(), v) == loop.end() ? inside : outside;
    rows.insert(rows.end(), {2 * v, 2 * v + 1});
  }
  const Eigen::MatrixXd S =
      A(outside, outside) -
      A(outside, inside) * definite_solution(A(inside, inside), A(inside, outside));
  const auto n = static_cast<Eigen::Index>(loop.size());
  Eigen::MatrixXd constants = Eigen::MatrixXd::Zero(2 * n, 2);
  for (Eigen::Index i = 0; i < n; ++i) constants(2 * i, 0) = constants(2 * i + 1, 1) = 1;
  // Constants have energy 0; they are put out of the way.
  const Eigen::MatrixXd shifted = S + 100 * constants * constants.transpose();
  return symmetric_eigenvalues(shifted);
}

double distance_from_disk(const CGP::internal::Parameterization_result& result,
                          const Mesh_view& disk)
{
  return CGP::align(CGP::in_space(result.z), disk.positions()).rms;
}

TEST(Spectral_parameterization, of_caps_has_the_distortion_of_the_reference_implementation)
{
  struct Case {
    double angle;
    int n;
    double faces, vertices;  // Q
  };
  for (const Case& c : {Case{pi / 3, 8, 1.02976, 1.02985},
                        {pi / 3, 16, 1.01483, 1.01485},
                        {pi / 2, 8, 1.06704, 1.06714},
                        {pi / 2, 16, 1.03314, 1.03316},
                        {.8 * pi, 8, 1.22745, 1.22854},
                        {.8 * pi, 16, 1.11051, 1.11070}}) {
    const Mesh_view plane = disk(c.n), cap = cap_from_disk(plane, c.angle);
    const auto faces = flattened(cap), vertices = flattened(cap, Normals::of_vertices);
    ASSERT_TRUE(faces.report && vertices.report);
    EXPECT_NEAR(faces.report.conformality.quasi_conformal.mean, c.faces, 6e-6);
    EXPECT_NEAR(vertices.report.conformality.quasi_conformal.mean, c.vertices, 1e-3);
    EXPECT_EQ(faces.report.conformality.flipped_faces, 0);
  }
}

TEST(Spectral_parameterization, of_a_cap_is_its_stereographic_projection)
{
  const Mesh_view plane = disk(8), cap = cap_from_disk(plane, pi / 3);
  EXPECT_LT(distance_from_disk(flattened(cap), plane), 2e-4);
  EXPECT_LT(distance_from_disk(flattened(cap, Normals::of_vertices), plane), 5e-4);
}

TEST(Spectral_parameterization, has_the_eigenvalues_of_the_definition_each_of_them_twice)
{
  const Mesh_view mesh = cap_from_disk(jittered_disk(5, .2), 2.);
  const Eigen::VectorXd expected = eigenvalues_by_definition(mesh);
  EXPECT_NEAR(expected[1], expected[0], 1e-12);
  EXPECT_NEAR(expected[3], expected[2], 1e-12);
  const auto result = flattened(mesh);
  EXPECT_NEAR(result.report.eigenvalue, expected[0], 1e-9);
  EXPECT_NEAR(result.report.next_eigenvalue, expected[2], 1e-6);
}

TEST(Spectral_parameterization, with_normals_of_vertices_has_simple_eigenvalues)
{
  const auto result = flattened(cap_from_disk(jittered_disk(5, .2), 2.), Normals::of_vertices);
  ASSERT_TRUE(result.report);
  EXPECT_GT(result.report.next_eigenvalue, 1.001 * result.report.eigenvalue);
}

TEST(Spectral_parameterization, leaves_flat_surfaces_as_they_are)
{
  for (const Mesh_view& mesh : {jittered_disk(6, .3), grid(7, 4, 3, 1), annulus(.4, 1, 24, 4)})
    for (const auto normals : {Normals::of_faces, Normals::of_vertices}) {
      const auto result = flattened(mesh, normals);
      ASSERT_TRUE(result.report);
      EXPECT_NEAR(result.report.eigenvalue, 0, 1e-10);
      EXPECT_LT(CGP::align(CGP::in_space(result.z), mesh.positions()).max, 1e-7);
      EXPECT_NEAR(result.report.conformality.quasi_conformal.max, 1, 1e-5);
    }
}

TEST(Spectral_parameterization, does_not_see_how_a_surface_lies_in_space)
{
  const Mesh_view mesh = cap_from_disk(jittered_disk(6, .2), 2.);
  const auto expected = flattened(mesh);
  for (const double scale : {1e-200, 1., 1e200}) {
    const Eigen::Matrix3d R = scale * Random(3).rotation();
    const Eigen::Vector3d offset = scale * Eigen::Vector3d(5, -7, 3);
    const auto result = flattened(
        mapped(mesh, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(R * p + offset); }));
    EXPECT_LT((result.z / scale - expected.z).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST(Spectral_parameterization, does_not_depend_on_the_order_of_vertices)
{
  const Mesh_view mesh = cap_from_disk(jittered_disk(6, .2), 2.);
  std::vector<int> order = random_permutation(mesh.size_of_vertices(), 5);
  const auto one = flattened(mesh), other = flattened(renumbered(mesh, order));
  Points moved = CGP::in_space(other.z), same = moved;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) same.col(v) = moved.col(order[at(v)]);
  EXPECT_LT(CGP::align(same, CGP::in_space(one.z)).max, 1e-7);
}

TEST(Spectral_parameterization, makes_a_ring_of_a_cylinder)
{
  for (const auto boundary : {CGP::Parameterization_options::Boundary::longest_loop,
                              CGP::Parameterization_options::Boundary::all_loops}) {
    const Mesh_view mesh = mapped(cylinder(1, 1, 48, 8), [](const Eigen::Vector3d& p) {
      const double r = 1 + 1e-3 * p.z();  // so that one loop is longer
      return Eigen::Vector3d(r * p.x(), r * p.y(), p.z());
    });
    CGP::Parameterization_options options;
    options.boundary = boundary;
    const auto result = CGP::spectral_parameterization(mesh, options);
    ASSERT_TRUE(result.report);
    EXPECT_EQ(result.report.boundary_loops, 2);
    EXPECT_EQ(result.report.normalized_vertices,
              boundary == CGP::Parameterization_options::Boundary::all_loops ? 96 : 48);
    EXPECT_EQ(result.report.conformality.flipped_faces, 0);
    const double outer = result.z.cwiseAbs().maxCoeff(), inner = result.z.cwiseAbs().minCoeff();
    EXPECT_NEAR(std::log(outer / inner), 1, .02);
    EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.1);
  }
}

TEST(Spectral_parameterization, has_the_area_of_the_surface_around_the_origin)
{
  const Mesh_view mesh = scaled(cap_from_disk(disk(6), 2.), 5);
  const auto result = flattened(mesh);
  EXPECT_NEAR(area({CGP::in_space(result.z), mesh.corners()}), area(mesh), 1e-10);
  const CGP::internal::Vertex_loop loop = CGP::boundary_loops(mesh)[0];
  EXPECT_LT(std::abs(result.z(loop).sum()), 1e-10);
  EXPECT_GT(result.z[loop[0]].real(), 1);
  EXPECT_NEAR(result.z[loop[0]].imag(), 0, 1e-12);
}

TEST(Spectral_parameterization, works_with_other_solvers)
{
  const Mesh_view mesh = cap_from_disk(jittered_disk(5, .2), 2.);
  for (const auto normals : {Normals::of_faces, Normals::of_vertices}) {
    CGP::Parameterization_options options;
    options.normals = normals;
    options.tolerance = 1e-8;
    options.solvers = CGP::Eigen_hermitian_solver_traits();
    const auto other = CGP::spectral_parameterization(mesh, options);
    EXPECT_LT((other.z - flattened(mesh, normals).z).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST(Spectral_parameterization, of_one_or_two_triangles_is_an_isometry)
{
  for (const Mesh_view& mesh : {single_triangle(), unit_square()}) {
    const auto result = flattened(mesh);
    ASSERT_TRUE(result.report);
    EXPECT_NEAR(result.report.conformality.scale.min_scale, 1, 1e-7);
    EXPECT_NEAR(result.report.conformality.quasi_conformal.max, 1, 1e-6);
  }
}

TEST(Spectral_parameterization, tells_that_it_has_not_converged)
{
  CGP::Parameterization_options options;
  options.maximum_number_of_iterations = 1;
  options.tolerance = 1e-12;
  const auto result = CGP::spectral_parameterization(cap_from_disk(disk(6), 2.), options);
  EXPECT_FALSE(result.report);
  EXPECT_EQ(result.report.iterations, 1);
}

TEST(Spectral_parameterization, counts_faces_that_flip)
{
  const auto result = flattened(without_face(perturbed(icosphere(2), .15), 0));
  ASSERT_TRUE(result.report);
  EXPECT_GT(result.report.conformality.flipped_faces, 0);
}

TEST(Spectral_parameterization, refuses_what_has_no_boundary_or_is_no_surface)
{
  const auto refused = [](const Mesh_view& mesh) {
    try {
      (void)CGP::spectral_parameterization(mesh, {}, "here");
    } catch (const CGP::Precondition_error& error) {
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  EXPECT_EQ(refused(icosphere(1)),
            "here: the surface is closed; one with a boundary is needed, cut it open");
  EXPECT_NE(refused(disjoint_union(disk(2), disk(2), {3, 0, 0})).find("2 components"),
            std::string::npos);
  Mesh_view broken = disk(2);
  Points p = broken.positions();
  p(1, 3) = std::numeric_limits<double>::quiet_NaN();
  broken.set_positions(p);
  EXPECT_NE(refused(broken).find("vertex 3"), std::string::npos);
  EXPECT_NE(refused({Points::Zero(3, 0), {}}).find("no faces"), std::string::npos);
}

CGP::Solver_status failure;
int tries = 0;

/// a solver that fails as it is told
template <class Scalar>
struct Failing_solver : CGP::Supernodal_cholesky<Scalar> {
  CGP::Solver_status factorize(const CGP::Hermitian_sparse_matrix<Scalar>&, const Eigen::VectorXd&)
  {
    ++tries;
    return failure;
  }
};
struct Failing_solver_traits {
  template <class Scalar>
  using Solver = Failing_solver<Scalar>;
};

std::string message_of_failure(CGP::Solver_status status)
{
  failure = status;
  tries = 0;
  try {
    CGP::Parameterization_options options;
    options.solvers = Failing_solver_traits();
    (void)CGP::spectral_parameterization(disk(2), options);
  } catch (const CGP::Solver_error& error) {
    return error.what();
  }
  return "not thrown";
}

TEST(Spectral_parameterization, throws_if_the_solver_fails)
{
  const std::string indefinite = message_of_failure(CGP::Solver_status::not_positive_definite);
  EXPECT_NE(indefinite.find("factorization of the conformal energy failed"), std::string::npos);
  EXPECT_EQ(tries, 3);  // with ever larger shifts
}

TEST(Spectral_parameterization, does_not_try_again_where_a_larger_shift_is_no_help)
{
  const std::string message = message_of_failure(CGP::Solver_status::out_of_memory);
  EXPECT_NE(message.find("failed: out of memory"), std::string::npos);
  EXPECT_EQ(tries, 1);
}

TEST(Parameterization_report, is_written_in_words)
{
  std::ostringstream text;
  text << flattened(disk(3)).report;
  EXPECT_NE(text.str().find("eigenvector            found"), std::string::npos);
  EXPECT_NE(text.str().find("flipped faces          0\n"), std::string::npos);
}

}  // namespace cgp_test::spectral_parameterization_tests
