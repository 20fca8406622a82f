// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
// Tests include/Conformal_geometry_processing/spin/Prescribed_boundary.h
#include <Conformal_geometry_processing/spin/curvature_difference.h>

#include <limits>

#include "spin/boundary_tools.h"
#include "support/moebius.h"

namespace cgp_test::spin_transformation_curve_positions_tests {

/// New positions of the boundary and of curves inside.

/// the ring of the disk that has 6 k vertices
std::vector<int> ring(int k)
{
  std::vector<int> vertices;
  for (int i = 0; i < 6 * k; ++i) vertices.push_back(1 + 3 * k * (k - 1) + i);
  return vertices;
}

/// the boundary and the curves of a surface, with its normals as the mesh has them
Boundary_condition curves_of(const Mesh_view& surface, std::vector<std::vector<int>> curves)
{
  Boundary_condition condition;
  condition.kind = Boundary_condition::Kind::positions;
  condition.curves = std::move(curves);
  const CGP::internal::Boundary_frames b = CGP::frames_of(surface, condition);
  const auto count = static_cast<Eigen::Index>(b.vertices.size());
  condition.targets.resize(3, count);
  condition.normals.resize(3, count);
  for (std::size_t k = 0; k < b.vertices.size(); ++k) {
    condition.targets.col(int(k)) = surface.position(b.vertices[k]);
    condition.normals.col(int(k)) = b.normal(k);
  }
  return condition;
}

CGP::Spin_result flat_disk_to(const Boundary_condition& condition, const Mesh_view& mesh)
{
  return CGP::Spin_transformation(mesh, {condition}).transform(constant_potential(mesh, 0));
}

/// the disk with a circular ridge
Mesh_view ridge(const Mesh_view& mesh)
{
  return mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double s = 1 - p.squaredNorm();
    return {p.x(), p.y(), .8 * s * s * p.squaredNorm()};
  });
}

TEST(Spin_transformation_with_curves, finds_the_moebius_image_that_they_lie_on)
{
  std::vector<double> h, errors;
  for (const int n : {8, 16, 32}) {
    const Mesh_view mesh = disk(n), image = inverted(mesh, {.4, -.3, 1.2});
    const CGP::Spin_result r =
        CGP::Spin_transformation(mesh, {curves_of(image, {ring(n / 4), ring(n / 2)})})
            .transform(CGP::curvature_difference(mesh, image.positions()));
    EXPECT_TRUE(r.report);
    h.push_back(1. / n);
    errors.push_back(rms_distance(r.positions, image.positions()));
  }
  EXPECT_GT(slope(h, errors), .9);
  EXPECT_LT(errors.back(), 1e-3);
}

TEST(Spin_transformation_with_curves, keeps_them_where_they_were_put)
{
  const Mesh_view mesh = disk(12), image = ridge(mesh);
  const std::vector<int> crest = ring(7);
  const CGP::Spin_result r = flat_disk_to(curves_of(image, {crest}), mesh);
  EXPECT_TRUE(r.report);
  EXPECT_LT(r.report.position_error.max, 1e-13);
  for (const int v : crest) EXPECT_LT((r.positions.col(v) - image.position(v)).norm(), 1e-13);
  // The boundary alone leaves the disk flat.
  const CGP::Spin_result flat = flat_disk_to(curves_of(mesh, {}), mesh);
  EXPECT_LT(flat.positions.row(2).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_GT(mean_Q(r), 1.01);
}

TEST(Spin_transformation_with_curves, trades_them_for_conformality_by_their_weight)
{
  const Mesh_view mesh = disk(12);
  Boundary_condition condition = curves_of(ridge(mesh), {ring(7)});
  double Q = 1, distance = std::numeric_limits<double>::infinity();
  for (const double weight : {.1, 1., 10., 100., 1000.}) {
    condition.weight = weight;
    const CGP::Spin_result r = flat_disk_to(condition, mesh);
    EXPECT_TRUE(r.report);
    EXPECT_GT(mean_Q(r), Q);
    EXPECT_LT(r.report.position_error.mean, distance);
    Q = mean_Q(r);
    distance = r.report.position_error.mean;
  }
  condition.weight = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(Q, mean_Q(flat_disk_to(condition, mesh)), 1e-2);
}

TEST(Spin_transformation_with_curves, wants_them_inside_and_apart)
{
  const Mesh_view mesh = disk(4);
  const auto refusal = [&](std::vector<std::vector<int>> curves) {
    Boundary_condition condition = curves_of(mesh, {});
    condition.curves = std::move(curves);
    return refusal_of([&] { CGP::Spin_transformation(mesh, {condition}, "f"); });
  };
  EXPECT_EQ(refusal({{1, 2}}), "a curve of 2 vertices; at least three are needed");
  for (const std::vector<int>& curve : {std::vector<int>{1, 2, 37}, {1, 2, -1}, {1, 2, 61}})
    EXPECT_EQ(refusal({curve}), "vertex " + std::to_string(curve[2]) +
                                    " of a curve is not inside the surface, or is on curves twice");
  EXPECT_EQ(refusal({ring(2), {1, 2, 7}}),
            "vertex 7 of a curve is not inside the surface, or is on curves twice");
  EXPECT_EQ(refusal({ring(2)}),
            "24 positions, one per vertex of the boundary and the curves is needed: 36");
}

}  // namespace cgp_test::spin_transformation_curve_positions_tests
