// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Relaxed_positions.h
// Tests spin/Spin_residual.h spin/Period_residual.h
#include <Conformal_geometry_processing/spin/Relaxed_positions.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "support/control_points.h"
#include "support/limbs.h"
#include "support/meshes.h"

namespace cgp_test::relaxed_positions_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Always_go_further;
using CGP::internal::Relaxed_positions;
using Spins = CGP::Quaternion_vector<double>;

const double exact = std::numeric_limits<double>::infinity();

/// one of eight points is moved
struct Dragged {
  explicit Dragged(const Mesh_view& mesh, double weight = exact)
      : transformation(mesh),
        points(one_moved(mesh, 8, .3)),
        relaxed(transformation,
                {points, {}, Eigen::VectorXd::Zero(mesh.size_of_vertices()), {}, weight},
                targets(points))
  {}

  Points targets(const std::vector<Control_point>& of) const
  {
    return transformation.domain().frame().to_frame(CGP::internal::targets_of(of));
  }

  CGP::Spin_transformation transformation;
  std::vector<Control_point> points;
  Relaxed_positions relaxed;
};

TEST(Relaxed_positions, meets_targets_and_keeps_the_factor_while_they_move_little)
{
  const Mesh_view mesh = dumbbell(2);
  Dragged d(mesh);
  EXPECT_FALSE(d.relaxed.is_met());
  d.relaxed.go_on(Always_go_further());
  EXPECT_TRUE(d.relaxed.is_met());
  EXPECT_TRUE(d.relaxed.present().report);
  d.relaxed.reset_costs();
  d.relaxed.set_targets(d.targets(one_moved(mesh, 8, .31)));
  d.relaxed.go_on(Always_go_further());
  EXPECT_TRUE(d.relaxed.is_met());
  const CGP::Spin_report report = d.relaxed.present().report;
  EXPECT_TRUE(report);
  EXPECT_TRUE(report.is_relaxed);
  EXPECT_EQ(report.factorizations, 0);
  EXPECT_LE(report.solves, 60);
}

TEST(Relaxed_positions, come_nearer_with_a_larger_weight)
{
  double last = 1;
  for (const double weight : {10., 1e3, 1e5}) {
    Dragged d(dumbbell(2), weight);
    d.relaxed.go_on(Always_go_further());
    EXPECT_LT(d.relaxed.distance(), last / 4) << weight;
    last = d.relaxed.distance();
  }
}

TEST(Relaxed_positions, go_back)
{
  const Mesh_view mesh = dumbbell(2);
  Dragged d(mesh);
  const Relaxed_positions::State before = d.relaxed.state();
  const Points points = d.relaxed.present_points();
  d.relaxed.go_on(Always_go_further());
  EXPECT_GT((d.relaxed.present_points() - points).norm(), .1);
  d.relaxed.restart(before);
  EXPECT_LT((d.relaxed.present_points() - points).norm(), 1e-12);
}

}  // namespace cgp_test::relaxed_positions_tests
