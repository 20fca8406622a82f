// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests flow/Curvature_filter.h
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/flow/Curvature_filter.h>
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "flow_tools.h"
#include "support/random.h"
#include "support/spheres.h"

namespace cgp_test::face_filter_tests {

using CGP::internal::Face_filter;

TEST(Face_filter, keeps_constants_and_means)
{
  const Mesh_view mesh = perturbed(bumpy_sphere(3), .05);
  const Face_filter filter(mesh, {});
  const Eigen::Vector3d c(1, -2, 3);
  const Points constant = c.replicate(1, mesh.size_of_vertices());
  EXPECT_LT((filter.settled(constant) - constant).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Points f = filter.settled(mesh.positions());
  EXPECT_LT(((f - mesh.positions()) * areas).norm(), 1e-12);
  EXPECT_GT((f - mesh.positions()).norm(), 1e-3);
}

// (2 S)^2 of the coordinates of a round sphere, where -L f is 2 M f, with S the area of a vertex.
TEST(Face_filter, leaves_what_is_wide_up_to_the_fourth_power_of_the_edges)
{
  for (const int level : {3, 4, 5}) {
    const Mesh_view mesh = icosphere(level);
    const double S = 4 * pi / mesh.size_of_vertices();
    const Points change = mesh.positions() - Face_filter(mesh, {}).settled(mesh.positions());
    EXPECT_NEAR(change.norm() / mesh.positions().norm(), 4 * S * S, .2 * 4 * S * S) << level;
  }
}

/// a bumpy ball as marching tetrahedra make it of a grid of n^3 cubes: a third of the faces are
/// thin, and far from Delaunay
Mesh_view marched_ball(int n)
{
  const auto at = [&](int i) { return -1.35 + 2.7 * (i + .137) / n; };
  const auto value = [](const Eigen::Vector3d& p) {
    return p.norm() - 1 - .12 * std::sin(3 * p.x() + 1) * std::cos(2 * p.y() - p.z());
  };
  const auto corner = [&](int i) {
    const int m = n + 1;
    return Eigen::Vector3d(at(i % m), at(i / m % m), at(i / m / m));
  };
  std::map<std::pair<int, int>, int> numbers;
  std::vector<Eigen::Vector3d> points;
  CGP::Mesh_view::Corners faces;
  const auto cut = [&](int inside, int outside) {
    const auto [found, is_new] = numbers.try_emplace(std::minmax(inside, outside), points.size());
    if (is_new) {
      const Eigen::Vector3d a = corner(inside), b = corner(outside);
      points.push_back(a + value(a) / (value(a) - value(b)) * (b - a));
    }
    return found->second;
  };
  const auto add = [&](int a, int b, int c, const Eigen::Vector3d& outward) {
    const auto& p = points;
    const auto at_ = [&](int i) { return p[static_cast<std::size_t>(i)]; };
    const bool is_out = (at_(b) - at_(a)).cross(at_(c) - at_(a)).dot(outward) > 0;
    faces.push_back(is_out ? std::array{a, b, c} : std::array{a, c, b});
  };
  const auto march = [&](const std::array<int, 4>& tetrahedron) {
    std::vector<int> in, out;
    for (const int c : tetrahedron) (value(corner(c)) < 0 ? in : out).push_back(c);
    if (in.empty() || out.empty()) return;
    const Eigen::Vector3d outward = corner(out[0]) - corner(in[0]);
    if (in.size() == 2) {
      const int a = cut(in[0], out[0]), b = cut(in[0], out[1]);
      const int c = cut(in[1], out[1]), d = cut(in[1], out[0]);
      add(a, b, c, outward);
      add(a, c, d, outward);
    } else if (in.size() == 1) {
      add(cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2]), outward);
    } else {
      add(cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0]), outward);
    }
  };
  const int m = n + 1, steps[] = {1, m, m * m};
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const int c = x + m * (y + m * z);
        std::array<int, 3> order = {0, 1, 2};
        do {  // six tetrahedra along the diagonal of a cube
          const int a = c + steps[order[0]], b = a + steps[order[1]], d = b + steps[order[2]];
          march({c, a, b, d});
        } while (std::next_permutation(order.begin(), order.end()));
      }
  Points p(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t v = 0; v < points.size(); ++v) p.col(static_cast<Eigen::Index>(v)) = points[v];
  return {std::move(p), std::move(faces)};
}

// On each of them the flow needs its filter.
TEST(Face_filter, makes_flows_round_on_thin_faces_of_any_size)
{
  const Mesh_view mesh = marched_ball(10);
  const auto settled = [&](double size) {
    CGP::Flow_options options;
    options.max_steps = 3;
    CGP::Conformal_willmore_flow flow(scaled(mesh, size), options);
    EXPECT_TRUE(flow.run()) << size;
    return Points(flow.positions() / size);
  };
  const Points once = settled(1);
  for (const double size : {1e-150, 1e-30, 1e150})
    EXPECT_LT((settled(size) - once).cwiseAbs().maxCoeff(), 1e-7) << size;
}

// Round, and conformal, on thin faces that the flow does not use.
TEST(Face_filter, makes_flows_round_on_thin_faces)
{
  for (const int n : {10, 14, 20}) {
    const Mesh_view mesh = marched_ball(n);
    CGP::Flow_options options;
    options.max_steps = 10;
    CGP::Conformal_willmore_flow flow(mesh, options);
    const CGP::Flow_report report = flow.run();
    EXPECT_TRUE(report) << to_string(report.stop) << report.message;
    const Mesh_view after(flow.positions(), mesh.corners());
    const Mesh_view raw(flow.mesh().positions(), mesh.corners());
    EXPECT_LT(CGP::willmore_energy(after), 1.03 * 4 * pi) << n;
    EXPECT_GT(CGP::willmore_energy(raw), 1.2 * CGP::willmore_energy(after)) << n;
    EXPECT_NEAR(report.energy_of_faces, CGP::willmore_energy(after), 1e-9);
    EXPECT_LT(CGP::quasi_conformal_error(mesh, after.positions()).mean,
              CGP::quasi_conformal_error(mesh, raw.positions()).mean);
  }
}

// The faces of a prism stay thin where its edges are flipped before the flow.
TEST(Face_filter, is_as_good_for_a_flow_on_flipped_edges)
{
  struct Case {
    int teeth, layers;
    double depth;
  };
  int settled = 0;
  for (const Case& c : {Case{8, 1, .1}, Case{8, 3, .3}, Case{16, 1, .1}, Case{16, 3, .3}}) {
    const Mesh_view thin = gear(c.teeth, c.depth, c.layers, 3);
    std::vector<std::array<int, 2>> flips;
    const Mesh_view flipped = CGP::internal::delaunay_by_chords(thin, 0, flips);
    EXPECT_GT(flips.size(), 20U);
    CGP::Conformal_willmore_flow kept(thin), flow(flipped);
    const CGP::Flow_report of_thin = kept.run(), report = flow.run();
    EXPECT_LT(report.energy_of_faces, 1.05 * of_thin.energy_of_faces) << c.teeth << ' ' << c.layers;
    EXPECT_LE(report.energy_of_faces, report.energy);
    settled += report.energy_of_faces < .85 * report.energy;
    EXPECT_NEAR(report.energy, CGP::willmore_energy(flow.mesh()), 1e-9);
    EXPECT_NEAR(report.energy_of_faces,
                CGP::willmore_energy(Mesh_view(flow.positions(), flipped.corners())), 1e-9);
  }
  EXPECT_GT(settled, 0);
}

}  // namespace cgp_test::face_filter_tests
