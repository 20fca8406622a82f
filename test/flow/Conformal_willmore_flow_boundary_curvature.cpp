// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bounded_flows.h"
#include "support/random_delaunay.h"

namespace cgp_test::conformal_willmore_flow_boundary_curvature_tests {

/// The mean curvature where a flow of a ring ends that keeps its binormals.
///
/// There the energy has no smaller neighbour in the conformal class, so H is a constant, the
/// multiplier of gamma, and a combination of the three functions that keep the ring closed. It is
/// constant if the class is that of a surface with these binormals and constant H. Bumps of height
/// e change the class of a zone of the sphere, which is such a surface, by O(e^2).

/// a zone of the unit sphere between circles about different axes, with bumps that leave its two
/// boundary loops and their binormals as they are
Mesh_view bumpy_zone(double height)
{
  const Circle hole{Eigen::Vector2d(.1, .05), .35};
  const Mesh_view plane = random_domain(.1, 3, {hole});
  const Mesh_view zone = cap_from_disk(plane, 1.4);
  Points f = zone.positions();
  for (int v = 0; v < f.cols(); ++v) {
    const Eigen::Vector2d z = plane.position(v).head<2>();
    const double to_rim = 1 - z.squaredNorm(),
                 to_hole = (z - hole.center).squaredNorm() - hole.radius * hole.radius;
    const double share = (std::min)(1., 32 * std::pow(to_rim * to_hole, 2));
    const Eigen::Vector3d p = f.col(v);
    const double bump =
        std::sin(3 * p.x()) * std::cos(2 * p.y()) + .5 * std::cos(2 * p.z() + p.x());
    f.col(v) *= 1 + height * share * bump;
  }
  return {f, zone.corners()};
}

/// shares of H, in the norm of the surface
struct Shares {
  double not_constant;  ///< beside the constants
  double unexplained;   ///< beside the constants and the functions of the periods

  double of_periods() const
  {
    return std::sqrt(not_constant * not_constant - unexplained * unexplained);
  }
};

Shares shares_at_the_end(double height)
{
  CGP::Flow_options options;
  options.surface.boundary = Boundary_condition::binormals();
  options.surface.exact_conformal_class =
      false;  // on so coarse a mesh the discrete class is narrower
  options.max_steps = 40;
  options.surface.max_period_defect = 1e-3;
  options.energy_tolerance = 1e-6;
  CGP::Conformal_willmore_flow flow(bumpy_zone(height), options);
  EXPECT_FALSE(flow.run().steps.empty());

  CGP::Spin_transformation transformation(flow.mesh(), {options.surface.boundary});
  const auto& exactness = transformation.exactness(CGP::Curvature_potential::On::vertices);
  const CGP::internal::Constraint_basis basis = exactness.basis();
  EXPECT_EQ(basis.rank(), 4);
  CGP::internal::Constraint_basis constants(exactness.areas);
  constants.add(Eigen::VectorXd::Ones(exactness.areas.size()));
  const Eigen::VectorXd H = CGP::mean_curvature(flow.mesh());
  const double all = basis.norm(H);
  return {basis.norm(constants.project_out(H)) / all, basis.norm(basis.project_out(H)) / all};
}

TEST(Conformal_willmore_flow_of_a_ring_with_binormals, ends_where_only_periods_hinder_it)
{
  const Shares round = shares_at_the_end(0), bumpy = shares_at_the_end(.06);
  EXPECT_LT(round.not_constant, .02);
  EXPECT_GT(bumpy.not_constant, .1);
  EXPECT_LT(bumpy.unexplained, .3 * bumpy.not_constant);
}

TEST(Conformal_willmore_flow_of_a_ring_with_binormals,
     ends_at_constant_mean_curvature_to_second_order_in_the_bumps)
{
  const std::vector<double> heights{.06, .03};
  std::vector<double> shares;
  for (const double height : heights) shares.push_back(shares_at_the_end(height).of_periods());
  EXPECT_GT(slope(heights, shares), 1.9);
  EXPECT_LT(shares_at_the_end(heights.back()).not_constant, .04);
}

}  // namespace cgp_test::conformal_willmore_flow_boundary_curvature_tests
