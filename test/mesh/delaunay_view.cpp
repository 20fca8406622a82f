// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "support/meshes.h"
#include "support/random.h"
#include "support/thin_faces.h"

namespace cgp_test::delaunay_view_tests {

namespace CGP = Conformal_geometry_processing;
using Conformal_geometry_processing::Delaunay_view;
using Conformal_geometry_processing::edge_lengths;
using Conformal_geometry_processing::internal::Common_subdivision;
using Conformal_geometry_processing::internal::Intrinsic_triangulation;

Mesh_view stretched_sphere()
{
  return mapped(bumpy_sphere(2),
                [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), 5 * p.y(), p.z()); });
}

Eigen::Vector3d normal(const CGP::Sheet& sheet)
{
  const Eigen::Vector3d e = sheet.vectors.col(0);
  return e.cross(sheet.vectors.col(1)).normalized();
}

/// the area of each face that the sheets of all triangles have together
Eigen::VectorXd areas_by_sheets(const Delaunay_view& view, int faces)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(faces);
  for (const auto& sheet : view.sheets()) areas[sheet.face] += sheet.share * sheet.area;
  return areas;
}

TEST(Delaunay_view, of_a_Delaunay_mesh_has_its_faces_for_sheets)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Delaunay_view view(mesh);
  EXPECT_EQ(view.number_of_flips(), 0);
  ASSERT_EQ(view.sheets().size(), at(mesh.size_of_faces()));
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& sheet = view.sheets()[at(f)];
    EXPECT_EQ(sheet.corners, mesh.corners(f));
    for (int c = 0; c < 3; ++c)
      EXPECT_EQ(view.ends(sheet.edges[at(c)]), mesh.ends(mesh.edge(3 * f + c)));
    EXPECT_EQ(sheet.face, f);
    EXPECT_EQ(sheet.triangle, f);
    EXPECT_EQ(sheet.share, 1);
    for (int c = 0; c < 3; ++c)
      EXPECT_LT((sheet.vectors.col(c) - mesh.vector(3 * f + c)).norm(), 1e-14);
  }
}

TEST(Delaunay_view, lays_each_triangle_out_in_the_planes_of_the_faces_that_it_passes)
{
  const Mesh_view mesh = stretched_sphere();
  const Delaunay_view view(mesh);
  EXPECT_GT(view.number_of_flips(), 50);
  EXPECT_GT(view.sheets().size(), at(view.size_of_triangles() + 50));
  for (const auto& sheet : view.sheets()) {
    EXPECT_GT(sheet.share, 0);
    EXPECT_LT(sheet.vectors.rowwise().sum().norm(), 1e-13);
    EXPECT_LT((normal(sheet) - mesh.double_area_vector(sheet.face).normalized()).norm(), 1e-11);
    const double twice = sheet.vectors.col(0).cross(sheet.vectors.col(1)).norm();
    EXPECT_NEAR(twice / 2, sheet.area, 1e-13);
  }
}

TEST(Delaunay_view, shares_the_area_of_every_face_among_the_triangles)
{
  const auto error = [](const Mesh_view& mesh, double mollification) {
    const Delaunay_view view(mesh, mollification);
    Eigen::VectorXd areas = areas_by_sheets(view, mesh.size_of_faces());
    for (int f = 0; f < mesh.size_of_faces(); ++f)
      areas[f] -= mesh.double_area_vector(f).norm() / 2;
    return areas.cwiseAbs().maxCoeff();
  };
  EXPECT_LT(error(stretched_sphere(), 1e-6), 1e-12);
  // Mollification makes triangles out of lines, as high as its root.
  EXPECT_LT(error(spoilt(icosphere(2)), 1e-6), 1e-3);
  EXPECT_LT(error(spoilt(icosphere(2)), 1e-10), 1e-6);
}

// By the theorem of Stokes, for df and the gradient of a hat function are both continuous along
// the edges of either triangulation.
TEST(Delaunay_view, has_opposite_edges_that_close_up_around_each_vertex_in_the_mean)
{
  const Mesh_view mesh = stretched_sphere();
  const Delaunay_view view(mesh);
  Points sum = Points::Zero(3, mesh.size_of_vertices());
  double largest = 0;  // of one triangle alone
  for (const auto& sheet : view.sheets())
    for (int c = 0; c < 3; ++c) {
      sum.col(sheet.corners[at(c)]) += sheet.share * sheet.vectors.col(c);
      largest = std::max(largest, sheet.share * sheet.vectors.col(c).norm());
    }
  EXPECT_GT(largest, .1);
  EXPECT_LT(sum.cwiseAbs().maxCoeff(), 1e-11);
}

TEST(Delaunay_view, takes_from_a_face_of_area_zero_its_edges_only)
{
  // A tetrahedron whose faces 4 and 5 are two triangles on one edge, with the apex on it.
  Mesh_view mesh = tetrahedron();
  const auto v = mesh.corners(0);
  Corners corners = mesh.corners();
  corners[0] = {v[1], v[2], 4};
  corners.push_back({v[2], v[0], 4});
  corners.push_back({v[0], v[1], 4});
  Points p(3, 5);
  p << mesh.positions(), (mesh.position(v[0]) + mesh.position(v[1])) / 2;
  mesh = Mesh_view(p, corners);
  const Intrinsic_triangulation triangles(mesh, edge_lengths(mesh).array() + 1e-6);
  const Common_subdivision subdivision(mesh, triangles);
  ASSERT_EQ(subdivision.pieces(5).size(), 2U);
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 2> mean = Eigen::Matrix<double, 3, 2>::Zero();
  for (const auto& piece : subdivision.pieces(5)) {
    EXPECT_LT(piece.weight, 1e-12);
    normals += piece.to_space.col(0).cross(piece.to_space.col(1));
    mean += piece.to_space / 2;
  }
  EXPECT_LT(normals.norm(), 1e-14);
  const Eigen::Vector3d edge = mesh.position(v[1]) - mesh.position(v[0]);
  EXPECT_LT(mean.transpose().rowwise().norm().minCoeff() - 1, 1e-14);
  EXPECT_LT((edge.normalized().cross(mean.col(0))).norm(), 1e-14);
  EXPECT_LT((edge.normalized().cross(mean.col(1))).norm(), 1e-14);
  // None of it is left when its long edge is flipped, and nothing of the others is lost.
  EXPECT_GT(Delaunay_view(mesh).number_of_flips(), 0);
  const Eigen::VectorXd areas = areas_by_sheets(Delaunay_view(mesh, 1e-10), mesh.size_of_faces());
  EXPECT_LT(areas[5], 1e-10);
  EXPECT_NEAR(areas.sum(), area(mesh), 1e-4 * area(mesh));
}

TEST(Delaunay_view, of_points_that_coincide_has_numbers_all_the_same)
{
  Mesh_view mesh = icosphere(1);
  Points p = mesh.positions();
  for (const int v : mesh.corners(3)) p.col(v) = p.col(mesh.corners(3)[0]);  // to one point
  mesh.set_positions(p);
  const Delaunay_view view(mesh);
  for (const auto& sheet : view.sheets()) {
    EXPECT_TRUE(sheet.vectors.allFinite());
    EXPECT_TRUE(std::isfinite(sheet.share));
    EXPECT_GT(sheet.area, 0);
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(CGP::cotangent(sheet, c)));
  }
}

/// two coaxial rings of n vertices, each joined by needles with a third of the other one
Mesh_view wound(int n)
{
  Points p(3, 2 * n);
  Corners corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.) * i / n;
    p.col(i) << std::cos(angle), std::sin(angle), 0;
    p.col(n + i) << std::cos(angle), std::sin(angle), 1;
    const int next = (i + 1) % n, across = n + (i + n / 3) % n, beyond = n + (i + n / 3 + 1) % n;
    corners.push_back({i, next, across});
    corners.push_back({next, beyond, across});
  }
  return {p, corners};
}

TEST(Delaunay_view, is_refused_where_it_would_be_quadratic)
{
  EXPECT_GT(Delaunay_view(wound(50)).size_of_sheets(), 10 * 100);
  EXPECT_THROW(Delaunay_view(wound(500)), CGP::Precondition_error);
}

TEST(Delaunay_view, moves_along_with_the_mesh)
{
  const Mesh_view mesh = spoilt(icosphere(1));
  const Delaunay_view before(mesh);
  const Eigen::Matrix3d R = Random(2).rotation();
  const Delaunay_view after(Mesh_view(3 * R * mesh.positions(), mesh.corners()));
  ASSERT_EQ(after.sheets().size(), before.sheets().size());
  for (std::size_t s = 0; s < before.sheets().size(); ++s) {
    ASSERT_EQ(after.sheets()[s].corners, before.sheets()[s].corners);
    EXPECT_NEAR(after.sheets()[s].area, 9 * before.sheets()[s].area, 1e-8);
  }
  // the mean normal of each triangle; those of its sheets alone are any that cancel out
  Points normals = Points::Zero(3, before.size_of_triangles()), turned = normals;
  for (const auto& sheet : before.sheets())
    normals.col(sheet.triangle) += sheet.share * normal(sheet);
  for (const auto& sheet : after.sheets())
    turned.col(sheet.triangle) += sheet.share * normal(sheet);
  EXPECT_LT((turned - R * normals).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(Delaunay_view, takes_closed_forms_along)
{
  const Mesh_view mesh = spoilt(torus(2, 1, 16, 8));
  const Eigen::MatrixXd generators = Conformal_geometry_processing::closed_generators(mesh);
  Eigen::MatrixXd forms(mesh.size_of_edges(), 5);  // d0 of the coordinates, too
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    forms.row(k) << generators.row(k),
        (mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0])).transpose();
  const Delaunay_view view(mesh, 1e-6, forms);
  ASSERT_EQ(view.forms().rows(), view.size_of_edges());
  double difference = 0, fraction = 0;
  for (int k = 0; k < view.size_of_edges(); ++k) {
    const Eigen::RowVectorXd form = view.forms().row(k);
    const Eigen::Vector3d chord = view.position(view.ends(k)[1]) - view.position(view.ends(k)[0]);
    difference = std::max(difference, (form.tail(3) - chord.transpose()).norm());
    for (int i = 0; i < 2; ++i)
      fraction = std::max(fraction, std::abs(form[i] - std::round(form[i])));
  }
  EXPECT_LT(difference, 1e-13);
  EXPECT_EQ(fraction, 0);
  EXPECT_GT(view.forms().leftCols(2).cwiseAbs().maxCoeff(), 0);
}

TEST(Delaunay_view, splits_caps_along_the_boundary_at_their_height)
{
  // one triangle, its corner 2 close to the opposite edge: two right triangles
  Points p(3, 3);
  p << 0, 1, .25, 0, 0, 1e-3, 0, 0, 0;
  const Delaunay_view view(Mesh_view(p, {{0, 1, 2}}));
  ASSERT_EQ(view.size_of_triangles(), 2);
  const CGP::Sheet left = view.sheet(0), right = view.sheet(1);
  EXPECT_NEAR(left.area, .25 * 1e-3 / 2, 1e-13);
  EXPECT_NEAR(right.area, .75 * 1e-3 / 2, 1e-13);
  EXPECT_EQ(left.corners, (std::array<int, 3>{0, 2, 2}));
  EXPECT_EQ(right.corners, (std::array<int, 3>{2, 1, 2}));
  EXPECT_EQ(left.edges[0], -1);
  EXPECT_EQ(right.edges[1], -1);
  ASSERT_EQ(view.size_of_edges(), 2);  // the long one has no weight, and is gone
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(view.ends(k)[1], 2);
    const double length = view.ends(k)[0] == 0 ? .25 : .75;
    EXPECT_NEAR(CGP::cotan_weights(view)[k], 1e-3 / length / 2, 1e-10);
  }
  for (const auto& sheet : view.sheets()) {
    EXPECT_NEAR(normal(sheet).z(), 1, 1e-12);
    EXPECT_LT(sheet.vectors.rowwise().sum().norm(), 1e-15);
  }
}

}  // namespace cgp_test::delaunay_view_tests
