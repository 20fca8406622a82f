// Tests include/Conformal_geometry_processing/flow/Volume_constraint.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Volume_constraint.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "flow_tools.h"
#include "support/bounded_meshes.h"
#include "support/random.h"
#include "support/spheres.h"
#include "support/tori.h"

namespace cgp_test::volume_constraint_tests {

using CGP::internal::Volume_constraint;

/// symmetric, irregular and coarse, with a handle
std::vector<Mesh_view> surfaces()
{
  return {stretched(icosphere(3), 1.8), perturbed(bumpy_sphere(2), .1),
          irregular_torus(2, 1, 24, 12)};
}

/// what a volume is kept by on a surface: half of that which it has
struct Kept {
  explicit Kept(const Mesh_view& surface)
      : mesh(surface),
        volume(surface, CGP::enclosure(surface).reduced_volume / 2, "test"),
        transformation(surface)
  {}

  Volume_constraint::Directions directions()
  {
    const auto& exactness = transformation.exactness(CGP::Curvature_potential::On::vertices);
    return volume.directions(transformation, exactness.basis(),
                             -CGP::mean_curvature(transformation.system().surface()));
  }

  /// the change of the logarithm of the volume by a step, rho in the frame
  double change(const Eigen::VectorXd& rho)
  {
    const Points f = transformation.closed_step(rho / transformation.domain().unit()).positions;
    return volume.distance(mesh.positions()) - volume.distance(f);
  }

  Mesh_view mesh;
  Volume_constraint volume;
  CGP::Spin_transformation transformation;
};

TEST(Volume_constraint, has_the_gradient_of_differences)
{
  for (const Mesh_view& mesh : surfaces()) {
    Kept kept(mesh);
    const auto& exactness = kept.transformation.exactness(CGP::Curvature_potential::On::vertices);
    kept.transformation.system().prepare_response();
    int solves = 0;
    const Eigen::VectorXd z = kept.volume.gradient(kept.transformation, solves);
    EXPECT_GT(solves, 0);
    const Eigen::VectorXd areas = kept.transformation.system().areas();
    Eigen::VectorXd rho =
        mesh.positions().row(0).transpose().cwiseAbs2() + mesh.positions().row(2).transpose();
    rho = exactness.basis().project_out(rho);
    rho *= 1e-4 / rho.norm();
    const double expected = areas.dot(z.cwiseProduct(rho));
    EXPECT_NEAR((kept.change(rho) - kept.change(-rho)) / 2, expected, 2e-3 * std::abs(expected));
  }
}

TEST(Volume_constraint, finds_a_descent_that_keeps_the_volume_and_a_way_that_changes_it)
{
  for (const Mesh_view& mesh : surfaces()) {
    Kept kept(mesh);
    const Volume_constraint::Directions d = kept.directions();
    const Eigen::VectorXd areas = kept.transformation.system().areas();
    const Eigen::VectorXd H = CGP::mean_curvature(kept.transformation.system().surface());
    EXPECT_LT(areas.dot(d.kept.cwiseProduct(H)), 0);
    std::vector<double> steps, changes;
    for (const double t : {.02, .01, .005}) {
      steps.push_back(t);
      changes.push_back(std::abs(kept.change(t / d.kept.cwiseAbs().maxCoeff() * d.kept)));
    }
    EXPECT_GT(slope(steps, changes), 1.7);
    EXPECT_NEAR(kept.change(1e-4 * d.filling), 1e-4, 2e-6);
    EXPECT_EQ(d.factorizations, 1);
  }
}

TEST(Volume_constraint, goes_a_twentieth_of_the_way_at_most)
{
  const Kept kept(bumpy_sphere(2));
  const Points& f = kept.mesh.positions();
  EXPECT_NEAR(kept.volume.distance(f), -std::log(2.), 1e-12);
  EXPECT_EQ(kept.volume.change(f, 1), -.05);
  EXPECT_EQ(kept.volume.change(f, .5), -.025);
  EXPECT_EQ(kept.volume.change(f, 0), 0);
  EXPECT_NEAR(kept.volume.equation(f, 0).residual(7 * f), 0, 1e-11);
  const Volume_constraint near(kept.mesh, 1.01 * CGP::enclosure(kept.mesh).reduced_volume, "test");
  EXPECT_NEAR(near.change(f, 1), std::log(1.01), 1e-12);
}

std::string refusal(const Mesh_view& mesh)
{
  try {
    const Volume_constraint volume(mesh, .5, "test");
  } catch (const CGP::Precondition_error& error) {
    return error.what();
  }
  return "";
}

TEST(Volume_constraint, takes_closed_surfaces_whose_normals_point_outward)
{
  EXPECT_NE(refusal(disk(3)).find("closed"), std::string::npos) << refusal(disk(3));
  EXPECT_NE(refusal(with_reversed_faces(icosphere(1))).find("outward"), std::string::npos);
  EXPECT_EQ(refusal(icosphere(1)), "");
}

}  // namespace cgp_test::volume_constraint_tests
