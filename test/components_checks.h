// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_parameterization.h>
#include <Conformal_geometry_processing/conformal_willmore_flow.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>

#include <complex>
#include <map>
#include <vector>

#include "spin_transform_checks.h"
#include "support/several_components.h"

/// Compares the results of the entry points on components of a mesh of any type with those on a
/// mesh with one component.
namespace cgp_test {

inline double rho_at(const Eigen::Vector3d& p)
{
  return .4 * std::sin(2 * p.x() + p.y()) + .3 * std::cos(3 * p.z());
}

template <class Mesh>
auto rho_map(const Mesh& mesh)
{
  const Mesh_view view = view_of(mesh);
  auto rho = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  int i = 0;
  for (const auto v : vertices(mesh)) put(rho, v, rho_at(view.position(i++)));
  return rho;
}

inline void expect_equal(const CGP::Conformality& a, const CGP::Conformality& b)
{
  EXPECT_EQ(a.quasi_conformal.mean, b.quasi_conformal.mean);
  EXPECT_EQ(a.quasi_conformal.max, b.quasi_conformal.max);
  EXPECT_EQ(a.length_cross_ratio.rms, b.length_cross_ratio.rms);
  EXPECT_EQ(a.scale.max_scale, b.scale.max_scale);
  EXPECT_EQ(a.flipped_faces, b.flipped_faces);
}

inline void expect_equal(const CGP::Spin_report& a, const CGP::Spin_report& b)
{
  EXPECT_EQ(a.eigenvalue, b.eigenvalue);
  EXPECT_EQ(a.residual, b.residual);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.closure_residual, b.closure_residual);
  EXPECT_EQ(a.min_spin_ratio, b.min_spin_ratio);
  expect_equal(a.conformality, b.conformality);
}

inline Points columns(const Points& all, const std::vector<int>& vertices)
{
  return all(Eigen::indexing::all, vertices);
}

/// to the bit
template <class Mesh>
void expect_spins_as_alone(Mesh mesh, const std::vector<Mesh_view>& parts, const Joined_meshes& all)
{
  auto lambda = get(CGAL::dynamic_vertex_property_t<Quaternion<double>>(), mesh);
  const auto reports =
      CGP::spin_transform_components(mesh, rho_map(mesh), CGP::parameters::vertex_spin_map(lambda));
  ASSERT_TRUE(reports);
  ASSERT_EQ(reports.components.size(), parts.size());
  const auto spins_of_all = spins(vertices(mesh), lambda, all.mesh.size_of_vertices());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    Mesh alone = to_cgal_mesh<Mesh>(parts[p]);
    auto spin = get(CGAL::dynamic_vertex_property_t<Quaternion<double>>(), alone);
    const auto report =
        CGP::spin_transform(alone, rho_map(alone), CGP::parameters::vertex_spin_map(spin));
    ASSERT_TRUE(report);
    EXPECT_EQ(columns(view_of(mesh).positions(), all.vertices[p]), view_of(alone).positions());
    const Quaternion_vector<double> of_part = spins_of_all(all.vertices[p]);
    EXPECT_EQ(of_part, spins(vertices(alone), spin, parts[p].size_of_vertices()));
    EXPECT_EQ(reports.components[p].first_vertex, all.vertices[p].front());
    EXPECT_EQ(reports.components[p].size_of_vertices, parts[p].size_of_vertices());
    EXPECT_EQ(reports.components[p].size_of_faces, parts[p].size_of_faces());
    expect_equal(reports.components[p].report, report);
  }
}

/// in any order of the components
template <class Mesh>
void expect_spins_as_alone()
{
  std::vector<Mesh_view> parts = surfaces_of_different_types();
  for (int order = 0; order < 2; ++order) {
    const Joined_meshes all = interleaved(parts);
    expect_spins_as_alone(to_cgal_mesh<Mesh>(all.mesh), parts, all);
    std::rotate(parts.begin(), parts.begin() + 1, parts.end());
  }
}

/// to the bit
template <class Mesh>
void expect_flows_as_alone()
{
  const std::vector<Mesh_view> parts = {bumpy_sphere(2),
                                        moved(scaled(bumpy_sphere(1), 4), {9, 0, 0})};
  const Joined_meshes all = interleaved(parts);
  Mesh mesh = to_cgal_mesh<Mesh>(all.mesh);
  const auto np = CGP::parameters::number_of_iterations(2);
  const auto reports = CGP::conformal_willmore_flow_components(mesh, np);
  ASSERT_TRUE(reports);
  ASSERT_EQ(reports.components.size(), parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    Mesh alone = to_cgal_mesh<Mesh>(parts[p]);
    const auto report = CGP::conformal_willmore_flow(alone, np);
    ASSERT_TRUE(report);
    EXPECT_EQ(columns(view_of(mesh).positions(), all.vertices[p]), view_of(alone).positions());
    EXPECT_EQ(reports.components[p].report.energy, report.energy);
    EXPECT_EQ(reports.components[p].report.steps.size(), report.steps.size());
    expect_equal(reports.components[p].report.conformality, report.conformality);
  }
}

template <class Mesh>
using Places = std::map<Vertex_of<Mesh>, std::complex<double>>;

/// Up to a translation
template <class Mesh>
void expect_flat_images_as_alone()
{
  const std::vector<Mesh_view> parts = {cap_from_disk(disk(5), 2.),
                                        moved(annulus(1, 2, 24, 3), {0, 7, 1})};
  const Joined_meshes all = interleaved(parts);
  const Mesh mesh = to_cgal_mesh<Mesh>(all.mesh);
  Places<Mesh> uv;
  const auto reports =
      CGP::conformal_parameterization_components(mesh, boost::make_assoc_property_map(uv));
  ASSERT_TRUE(reports);
  std::vector<std::complex<double>> z;
  for (const auto v : vertices(mesh)) z.push_back(uv.at(v));
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Mesh alone = to_cgal_mesh<Mesh>(parts[p]);
    Places<Mesh> expected;
    const auto report =
        CGP::conformal_parameterization(alone, boost::make_assoc_property_map(expected));
    ASSERT_TRUE(report);
    expect_equal(reports.components[p].report.conformality, report.conformality);
    const auto number = [&](int v) { return at(all.vertices[p][at(v)]); };
    int i = 0;
    std::complex<double> move;
    for (const auto v : vertices(alone)) {
      if (i == 0) move = z[number(0)] - expected.at(v);
      EXPECT_LT(std::abs(z[number(i++)] - expected.at(v) - move), 1e-14);
    }
  }
}

}  // namespace cgp_test
