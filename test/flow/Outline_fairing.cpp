// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/fair_region.h
#include <Conformal_geometry_processing/flow/fair_region.h>

#include <gtest/gtest.h>

#include "fairing_tools.h"
#include "support/bounded_meshes.h"
#include "support/tori.h"

namespace cgp_test::outline_fairing_tests {

std::vector<char> middle_of(const Mesh_view& mesh)
{
  return region_where(mesh, [](const auto& c) { return c.norm() < .7; });
}

Points start_of(const Mesh_view& mesh, const std::vector<char>& region)
{
  const CGP::internal::Fairing_patch patch(mesh, region, "test");
  return CGP::internal::Outline_fairing(patch).start();
}

Points turned(const Points& f)
{
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized(), offset(3, -4, 5);
  return (Eigen::AngleAxisd(1, axis).toRotationMatrix() * f).colwise() + offset;
}

// Whatever the plane was filled with, and wherever it is: K f = 0 holds for linear functions.
TEST(Outline_fairing, starts_flat_in_a_plane)
{
  const Mesh_view plane = jittered_disk(12, .3);
  const auto middle = middle_of(plane);
  for (const double height : {.2, 1.}) {
    const Mesh_view bumped = refilled(plane, middle, [&](const Eigen::Vector3d& p) {
      return Eigen::Vector3d(p.x(), p.y(), height * std::cos(2 * p.x()));
    });
    const Points flat = start_of(bumped, middle);
    EXPECT_LT(flat.row(2).lpNorm<Eigen::Infinity>(), 1e-10);
    const Points f = start_of({turned(bumped.positions()), plane.corners()}, middle);
    EXPECT_LT((f - turned(flat)).lpNorm<Eigen::Infinity>(), 1e-9);
  }
}

TEST(Outline_fairing, starts_with_less_energy_than_a_dent)
{
  const Mesh_view mesh = irregular_torus(3, 1, 60, 20);
  const auto top = region_where(
      mesh, [](const Eigen::Vector3d& c) { return (c - Eigen::Vector3d(3, 0, 1)).norm() < 1.1; });
  const Mesh_view dented = refilled(mesh, top, [](const Eigen::Vector3d& p) {
    const double d = (p - Eigen::Vector3d(3, 0, 1)).norm() / 1.1;
    return Eigen::Vector3d(p.x(), p.y(), p.z() - .6 * std::pow(1 - d * d, 2));
  });
  const CGP::internal::Fairing_patch patch(dented, top, "test");
  const auto energy = [&](const Points& f) {
    return CGP::internal::Bending_energy(patch, f).value();
  };
  const Points f = CGP::internal::Outline_fairing(patch).start();
  EXPECT_LT(energy(f), .5 * energy(patch.mesh().positions()));
}

}  // namespace cgp_test::outline_fairing_tests
