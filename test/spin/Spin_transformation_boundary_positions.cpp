// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
// Tests include/Conformal_geometry_processing/spin/Prescribed_boundary.h
#include <limits>

#include "spin/boundary_tools.h"
#include "support/random_delaunay.h"
#include "support/weierstrass.h"

namespace cgp_test::spin_transformation_boundary_positions_tests {

/// New positions of the boundary, against closed forms and tables computed by other code.

/// the boundary of a surface, with its normals as the mesh has them
Boundary_condition boundary_of(const Mesh_view& surface)
{
  return Boundary_condition::positions(
      at_boundary(surface, [](const Eigen::Vector3d& p, const auto&) { return p; }),
      at_boundary(surface,
                  [](const auto&, const auto& frame) -> Eigen::Vector3d { return frame.col(1); }));
}

double greatest_distance(const Points& a, const Points& b)
{
  return (a - b).colwise().norm().maxCoeff();
}

struct Row {
  double Q, distance;
};

/// surface(n) with the boundary of image(n), against the image
template <class Surface, class Image>
std::vector<Row> rows(Surface surface, Image image, double rho, bool greatest = false)
{
  std::vector<Row> list;
  for (const int n : {8, 16, 32, 64}) {
    const Mesh_view mesh = surface(n), exact = image(n);
    const CGP::Spin_result r = transformed(mesh, boundary_of(exact), constant_potential(mesh, rho));
    EXPECT_TRUE(r.report);
    const double distance = greatest ? greatest_distance(r.positions, exact.positions())
                                     : rms_distance(r.positions, exact.positions());
    list.push_back({mean_Q(r), distance});
  }
  return list;
}

void expect_rows(const std::vector<Row>& found, const std::vector<double>& Q,
                 const std::vector<double>& distance, double order)
{
  std::vector<double> errors;
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(found[i].Q - 1, Q[i] - 1, .02 * (Q[i] - 1)) << i;
    EXPECT_NEAR(found[i].distance, distance[i], .1 * distance[i]) << i;
    errors.push_back(found[i].distance);
  }
  expect_order(order, {errors[2], errors[3]});
}

TEST(Spin_transformation_to_new_positions, finds_the_holomorphic_map)
{
  expect_rows(rows(
                  disk, [](int n) { return mapped(disk(n), quadratic_map); }, 0),
              {1.05388, 1.02661, 1.01322, 1.00659}, {1.32e-4, 3.39e-5, 8.6e-6, 2.17e-6}, 2);
}

TEST(Spin_transformation_to_new_positions, finds_enneper_s_surface)
{
  expect_rows(rows(
                  disk, [](int n) { return enneper(disk(n)); }, 0),
              {1.05376, 1.02650, 1.01315, 1.00655}, {9.8e-4, 5.3e-4, 2.8e-4, 1.4e-4}, 1);
}

TEST(Spin_transformation_to_new_positions, flattens_the_hemisphere_within_its_boundary)
{
  const auto hemisphere = [](int n) { return cap_from_disk(disk(n), pi / 2); };
  expect_rows(rows(hemisphere, disk, -1, true), {1.06723, 1.03317, 1.01646, 1.00820},
              {3.4e-2, 1.7e-2, 8.6e-3, 4.3e-3}, 1);
}

// A ring turned inside out has spins that turn by a half along each loop, so that neither sign is
// nearer to 1 than the other.
TEST(Spin_transformation_to_new_positions, of_several_loops_agree_on_the_signs_of_spins)
{
  const Circle hole{{.1, .05}, .35}, other{{-.4, -.4}, .2};
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const std::vector<double> h{.1, .05};
    std::vector<double> errors;
    for (const double length : h) {
      const auto holes =
          seed % 2 == 0 ? std::vector<Circle>{hole} : std::vector<Circle>{hole, other};
      const Mesh_view plane = random_domain(length, seed, holes);
      const Weierstrass_surface X = Weierstrass_surface::random(300 + seed);
      const Mesh_view image = mapped(plane, [&](const Eigen::Vector3d& p) {
        const Complex w = .28 / (complex_of(p) - Complex(.1, .05));
        return X({w.real(), w.imag(), 0});
      });
      const CGP::Spin_result r =
          transformed(plane, boundary_of(image), constant_potential(plane, 0));
      EXPECT_TRUE(r.report) << seed << " " << length;
      errors.push_back(shape_error(r.positions, image.positions()));
    }
    EXPECT_LT(errors.back(), 1e-3) << seed;
    EXPECT_GT(slope(h, errors), .5) << seed;
  }
}

TEST(Spin_transformation_to_new_positions, gives_way_where_there_is_no_conformal_surface)
{
  // The hemisphere bent into a saddle: pointwise data leave little freedom.
  for (const int n : {16, 32}) {
    const Mesh_view mesh = cap_from_disk(disk(n), pi / 2);
    const Mesh_view image = mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return {p.x(), p.y(), p.z() + .25 * (p.x() * p.x() - p.y() * p.y())};
    });
    const CGP::Spin_result r = transformed(mesh, boundary_of(image), constant_potential(mesh, 0));
    EXPECT_NEAR(mean_Q(r), 1.2753, .02 * .2753);
  }
}

TEST(Spin_transformation_to_new_positions, is_judged_by_the_distortion_that_they_cost)
{
  const Mesh_view mesh = random_domain(.1, 5);
  const auto result = [&mesh](const Mesh_view& image) {
    return CGP::Spin_transformation(mesh, {boundary_of(image)})
        .transform(constant_potential(mesh, 0));
  };
  const auto ellipse = [&mesh](double a) {
    return mapped(mesh, [a](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return {a * p.x(), p.y(), 0};
    });
  };
  const Mesh_view saddle = mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {p.x(), p.y(), .2 * (p.x() * p.x() - p.y() * p.y())};
  });
  const Mesh_view slide = mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return Eigen::AngleAxisd(.1 * p.y(), Eigen::Vector3d(0, 0, 1)) * p;
  });
  for (const Mesh_view& image : {saddle, slide, ellipse(1.05), ellipse(1.3)}) {
    const CGP::Spin_result r = result(image);
    EXPECT_TRUE(r.report);
    EXPECT_EQ(r.report.boundary_fault, CGP::Spin_report::Boundary_fault::none);
    EXPECT_LT(r.report.position_error.max, 1e-14);
    EXPECT_GT(mean_Q(r), 1.005);
  }
  EXPECT_NEAR(mean_Q(result(ellipse(1.3))), 1.3, .02);  // as affine
  EXPECT_EQ(result(ellipse(1.8)).report.fault(), CGP::Spin_report::Fault::map);
}

TEST(Spin_transformation_to_new_positions, trades_them_for_conformality_by_their_weight)
{
  const Mesh_view mesh = random_domain(.1, 5);
  const Mesh_view saddle = mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {p.x(), p.y(), .2 * (p.x() * p.x() - p.y() * p.y())};
  });
  const auto result = [&](double weight) {
    Boundary_condition condition = boundary_of(saddle);
    condition.weight = weight;
    return CGP::Spin_transformation(mesh, {condition}).transform(constant_potential(mesh, 0));
  };
  const CGP::Spin_result exact = result(std::numeric_limits<double>::infinity());
  double Q = 1, distance = std::numeric_limits<double>::infinity();
  for (const double weight : {.1, 1., 10., 100., 1000.}) {
    const CGP::Spin_result r = result(weight);
    EXPECT_TRUE(r.report);
    EXPECT_GT(mean_Q(r), Q);
    EXPECT_LT(r.report.position_error.mean, distance);
    Q = mean_Q(r);
    distance = r.report.position_error.mean;
  }
  EXPECT_LT(mean_Q(result(.1)), 1.005);  // of the edges, at any weight
  EXPECT_LT(Q, mean_Q(exact));
  EXPECT_NEAR(Q, mean_Q(exact), 1e-3);
  EXPECT_LT(distance, 1e-4);
}

TEST(Spin_transformation_to_new_positions, with_a_weight_moves_with_the_curve)
{
  const Mesh_view mesh = cap_from_disk(jittered_disk(6, .3), 1), image = perturbed(mesh, .02);
  const Eigen::Matrix3d R = Random(2).rotation();
  const Eigen::Vector3d t(100, -200, 300);
  Boundary_condition here = boundary_of(image), there = here;
  there.targets = (3 * R * here.targets).colwise() + t;
  there.normals = R * here.normals;
  here.weight = there.weight = 5;
  const CGP::Spin_result a = transformed(mesh, here, constant_potential(mesh, .3)),
                         b = transformed(mesh, there, constant_potential(mesh, .3));
  EXPECT_LT(greatest_distance((3 * R * a.positions).colwise() + t, b.positions), 1e-11);
  EXPECT_NEAR(b.report.position_error.mean, 3 * a.report.position_error.mean, 1e-11);
}

TEST(Spin_transformation_to_new_positions, refuses_a_weight_that_is_none)
{
  Boundary_condition condition = boundary_of(disk(3));
  for (const double weight : {0., -1., std::numeric_limits<double>::quiet_NaN()}) {
    condition.weight = weight;
    EXPECT_EQ(refusal_of([&] { CGP::Spin_transformation(disk(3), {condition}, "f"); }),
              "the weight of positions must be positive");
  }
}

TEST(Spin_transformation_to_new_positions, keeps_the_boundary_where_it_was_put)
{
  const Mesh_view mesh = cap_from_disk(jittered_disk(6, .3), 1), image = perturbed(mesh, .02);
  const auto rho = potential_on_faces(mesh, [](const auto& p) { return std::sin(4 * p.x()); });
  const Boundary_condition condition = boundary_of(image);
  const CGP::Spin_result r = transformed(mesh, condition, rho);
  const std::vector<int> vertices = CGP::boundary_frames(mesh).vertices;
  for (std::size_t k = 0; k < vertices.size(); ++k)
    EXPECT_LT((r.positions.col(vertices[k]) - condition.targets.col(int(k))).norm(), 1e-14);
}

TEST(Spin_transformation_to_new_positions, moves_with_the_curve)
{
  const Mesh_view mesh = cap_from_disk(jittered_disk(6, .3), 1), image = perturbed(mesh, .02);
  const auto rho = potential_on_faces(mesh, [](const auto& p) { return std::sin(4 * p.x()); });
  const Eigen::Matrix3d R = Random(2).rotation();
  const Eigen::Vector3d t(100, -200, 300);
  const Boundary_condition here = boundary_of(image),
                           there = Boundary_condition::positions(
                               (3 * R * here.targets).colwise() + t, R * here.normals);
  const Points a = transformed(mesh, here, rho).positions;
  const Points b = transformed(mesh, there, rho).positions;
  EXPECT_LT(greatest_distance((3 * R * a).colwise() + t, b), 1e-11);
}

TEST(Spin_transformation_to_new_positions, refuses_a_curve_that_is_twisted_once)
{
  const Mesh_view mesh = disk(5);
  Boundary_condition condition = boundary_of(mesh);
  condition.normals = at_boundary(mesh, [](const Eigen::Vector3d& p, const auto& frame) {
    return Eigen::Vector3d(p.x() * frame.col(1) + p.y() * frame.col(2));
  });
  EXPECT_NE(refusal_of([&] {
              CGP::Spin_transformation(mesh, {condition}, "f");
            }).find("twisted by a full turn"),
            std::string::npos);
}

TEST(Spin_transformation_to_new_positions, refuses_to_move_afterwards)
{
  const Mesh_view mesh = disk(5);
  CGP::Spin_transformation transformation(mesh, {boundary_of(mesh)});
  EXPECT_EQ(refusal_of([&] { transformation.set_positions(2 * mesh.positions()); }),
            "a surface with prescribed boundary cannot move");
}

}  // namespace cgp_test::spin_transformation_boundary_positions_tests
