// Tests include/Conformal_geometry_processing/spin/turned_binormals.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/spin/turned_binormals.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/bounded_meshes.h"

namespace cgp_test::turned_binormals_tests {

namespace CGP = Conformal_geometry_processing;

/// the direction in the half plane through the z axis and a point
Eigen::Vector3d tilted(const Eigen::Vector3d& p, double angle)
{
  const Eigen::Vector3d outward = Eigen::Vector3d(p.x(), p.y(), 0).normalized();
  return std::cos(angle) * outward + std::sin(angle) * Eigen::Vector3d::UnitZ();
}

TEST(Turned_binormals, turn_evenly_from_a_disk_to_a_cap_and_beyond)
{
  // The binormals of a disk are horizontal; at a cap of polar angle 1 they point down by the
  // angle 1.
  const Mesh_view flat = disk(20), cap = cap_from_disk(flat, 1.);
  const std::vector<int> rim = CGP::boundary_frames(flat).vertices;
  for (const double t : {-0.5, 0., 0.3, 1., 2.}) {
    const Points B = CGP::turned_binormals(flat, cap, flat, t);
    for (std::size_t k = 0; k < rim.size(); ++k)
      EXPECT_LT((B.col(Eigen::Index(k)) - tilted(flat.position(rim[k]), -t)).norm(), 0.06) << t;
  }
}

TEST(Turned_binormals, are_those_of_the_surfaces_at_the_ends)
{
  const Mesh_view mesh = disk(5), cap = cap_from_disk(mesh, 1.3);
  const Eigen::AngleAxisd tilt(0.4,
                               Eigen::Vector3d::UnitX());  // turns binormals along the boundary
  const Mesh_view tilted_cap =
      mapped(cap, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return tilt * p; });
  const CGP::internal::Boundary_frames from = CGP::boundary_frames(mesh);
  for (const Mesh_view& to : {cap, tilted_cap}) {
    const CGP::internal::Boundary_frames wanted = CGP::boundary_frames(to);
    const Points start = CGP::turned_binormals(mesh, to, mesh, 0),
                 end = CGP::turned_binormals(mesh, to, mesh, 1);
    for (std::size_t k = 0; k < from.vertices.size(); ++k) {
      EXPECT_LT((start.col(Eigen::Index(k)) - from.binormal(k)).norm(), 1e-14);
      EXPECT_LT((end.col(Eigen::Index(k)) - wanted.binormal(k)).norm(), 1e-14);
    }
  }
}

TEST(Turned_binormals, turn_another_surface_by_as_much)
{
  // From a disk to a cap of polar angle 1, from that one as far again: to one of polar angle 2.
  const Mesh_view flat = disk(20), cap = cap_from_disk(flat, 1.);
  const std::vector<int> rim = CGP::boundary_frames(flat).vertices;
  const Points B = CGP::turned_binormals(flat, cap, cap, 1);
  for (std::size_t k = 0; k < rim.size(); ++k)
    EXPECT_LT((B.col(Eigen::Index(k)) - tilted(flat.position(rim[k]), -2)).norm(), 0.1);
}

TEST(Turned_binormals, turn_over_the_normal_by_half_a_turn)
{
  // The disk inside out through a half turn: its binormals point inward, exactly opposite.
  const Mesh_view mesh = unit_square();
  const Mesh_view opposite = mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return {-p.x(), -p.y(), p.z()};
  });
  const Points B = CGP::turned_binormals(mesh, opposite, mesh, 0.5);
  EXPECT_LT((B.colwise() - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

}  // namespace cgp_test::turned_binormals_tests
