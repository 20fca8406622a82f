// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Conformal_mesh_traits.h>

#include <gtest/gtest.h>

/// What every model of `ConformalMeshTraits` must fulfil.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;
using Spin = CGP::Quaternion<double>;

template <class Mesh>
void expect_initial_values(Mesh& mesh)
{
  const CGP::Conformal_mesh_traits<Mesh> traits(mesh);
  for (auto v : vertices(mesh)) {
    EXPECT_EQ(get(traits.vertex_curvature_potential_map(), v), 0.);
    EXPECT_EQ(get(traits.vertex_spin_map(), v), (Spin{1, 0, 0, 0}));
    const auto n = get(traits.vertex_normal_map(), v);
    EXPECT_TRUE(n.x() == 0 && n.y() == 0 && n.z() == 0);
  }
  for (auto f : faces(mesh)) EXPECT_EQ(get(traits.face_curvature_potential_map(), f), 0.);
}

/// Returns a different value for every element and every i
template <class Mesh>
void write_numbers(const Mesh& mesh, const CGP::Conformal_mesh_traits<Mesh>& traits, double i)
{
  using Normal_map = typename CGP::Conformal_mesh_traits<Mesh>::Vertex_normal_map;
  using Normal = typename boost::property_traits<Normal_map>::value_type;
  for (auto v : vertices(mesh)) {
    put(traits.vertex_curvature_potential_map(), v, i);
    put(traits.vertex_spin_map(), v, Spin{i, 1, 2, 3});
    put(traits.vertex_normal_map(), v, Normal(i, 1, 2));
    ++i;
  }
  for (auto f : faces(mesh)) put(traits.face_curvature_potential_map(), f, i++);
}

/// the traits hold what write_numbers() wrote
template <class Mesh>
void expect_numbers(const Mesh& mesh, const CGP::Conformal_mesh_traits<Mesh>& traits, double i)
{
  for (auto v : vertices(mesh)) {
    EXPECT_EQ(get(traits.vertex_curvature_potential_map(), v), i);
    EXPECT_EQ(get(traits.vertex_spin_map(), v), (Spin{i, 1, 2, 3}));
    const auto n = get(traits.vertex_normal_map(), v);
    EXPECT_TRUE(n.x() == i && n.y() == 1 && n.z() == 2);
    ++i;
  }
  for (auto f : faces(mesh)) EXPECT_EQ(get(traits.face_curvature_potential_map(), f), i++);
}

/// The maps store their values, and copies of the traits share them
template <class Mesh>
void expect_shared_values(Mesh& mesh)
{
  const CGP::Conformal_mesh_traits<Mesh> traits(mesh), copy = traits;
  write_numbers(mesh, traits, 5);
  expect_numbers(mesh, traits, 5);
  expect_numbers(mesh, copy, 5);
  write_numbers(mesh, copy, 7);
  expect_numbers(mesh, traits, 7);
}

/// a map may be used when the traits are gone
template <class Mesh>
void expect_maps_to_outlive_the_traits(Mesh& mesh)
{
  const auto rho = CGP::Conformal_mesh_traits<Mesh>(mesh).face_curvature_potential_map();
  for (auto f : faces(mesh)) {
    put(rho, f, 3.);
    EXPECT_EQ(get(rho, f), 3.);
  }
}

template <class Mesh>
void expect_a_model_of_conformal_mesh_traits(Mesh mesh)
{
  static_assert(std::is_same_v<typename CGP::Conformal_mesh_traits<Mesh>::Triangle_mesh, Mesh>);
  expect_initial_values(mesh);
  expect_shared_values(mesh);
  expect_maps_to_outlive_the_traits(mesh);
}

}  // namespace cgp_test
