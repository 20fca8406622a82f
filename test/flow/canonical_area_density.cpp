// Tests include/Conformal_geometry_processing/flow/canonical_area_density.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/algebra/Moebius_map.h>
#include <Conformal_geometry_processing/flow/Moebius_balancing.h>
#include <Conformal_geometry_processing/flow/canonical_area_density.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "support/decompositions.h"
#include "support/handlebodies.h"
#include "support/meshes.h"

namespace cgp_test::canonical_area_density_tests {

namespace CGP = Conformal_geometry_processing;

Eigen::VectorXd canonical_density(const Mesh_view& mesh)
{
  return CGP::canonical_area_density(mesh,
                                     CGP::Hodge_decomposition(mesh).harmonic_basis().one_forms);
}

Eigen::VectorXd canonical_areas(const Mesh_view& mesh)
{
  return CGP::canonical_vertex_areas(mesh, canonical_density(mesh));
}

Mesh_view inverted(const Mesh_view& mesh, const Eigen::Vector3d& c)
{
  return {CGP::Moebius_map::sphere_inversion(c).transform(mesh.positions()), mesh.corners()};
}

TEST(Canonical_metric, has_the_genus_as_its_area)
{
  for (const Mesh_view& mesh : {torus(2, 1, 20, 10), btorus(24), perturbed(btorus(12), .05)}) {
    EXPECT_NEAR(CGP::face_areas(mesh).dot(canonical_density(mesh)), 1, 1e-10);
    EXPECT_NEAR(canonical_areas(mesh).sum(), 1, 1e-10);
  }
  for (int genus : {2, 3, 7}) {
    EXPECT_NEAR(canonical_areas(holed_block(genus)).sum(), genus, 1e-10);
    EXPECT_NEAR(canonical_areas(smooth_handlebody(genus, 1)).sum(), genus, 1e-10);
  }
}

TEST(Canonical_metric, of_a_torus_of_revolution_is_flat)
{
  // Its forms are d phi and the conjugate one, both of length proportional to 1 / distance.
  const Mesh_view mesh = torus(std::sqrt(2.), 1, 60, 60);
  const Eigen::VectorXd u = canonical_density(mesh);
  Eigen::VectorXd product(u.size());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const Eigen::Vector3d p = (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
    product[f] = u[f] * p.head<2>().squaredNorm();
  }
  EXPECT_LT(product.maxCoeff(), 1.02 * product.mean());
  EXPECT_GT(product.minCoeff(), .98 * product.mean());
}

TEST(Canonical_metric, does_not_change_under_inversions_but_for_the_size_of_faces)
{
  std::vector<double> h, error;
  for (int n : {16, 32, 64}) {
    const Mesh_view mesh = btorus(n);
    const Eigen::VectorXd a = canonical_areas(mesh);
    const Eigen::VectorXd b = canonical_areas(inverted(mesh, {.25, .1, .15}));
    h.push_back(1. / n);
    error.push_back((a - b).lpNorm<1>());
  }
  EXPECT_NEAR(slope(h, error), 2, .15);
  EXPECT_LT(error.back(), 2e-3);
  // where the areas on the surface itself change much
  const Mesh_view mesh = btorus(16), image = inverted(mesh, {.25, .1, .15});
  EXPECT_GT(
      (CGP::vertex_areas(mesh) / area(mesh) - CGP::vertex_areas(image) / area(image)).lpNorm<1>(),
      .3);
}

TEST(Canonical_metric, does_not_depend_on_the_basis)
{
  const Mesh_view mesh = smooth_handlebody(2, 1);
  const CGP::Harmonic_basis basis = CGP::Hodge_decomposition(mesh).harmonic_basis();
  Eigen::Matrix4d A;
  A << random_numbers(16, 1).reshaped(4, 4);
  const Eigen::Matrix4d Q = orthogonal_factor(A);
  const Eigen::VectorXd u = CGP::canonical_area_density(mesh, basis.one_forms),
                        of_others = CGP::canonical_area_density(mesh, basis.one_forms * Q);
  EXPECT_LT((of_others - u).cwiseAbs().maxCoeff(), 1e-13 * u.maxCoeff());
}

TEST(Canonical_metric, as_a_target_undoes_the_inversion_of_a_symmetric_torus)
{
  // Reflections in three planes leave balanced surfaces of this class no inversion but the
  // identity.
  const Mesh_view mesh = torus(std::sqrt(2.), 1, 40, 40);
  const CGP::internal::Moebius_balancing balancing(canonical_areas(mesh));
  EXPECT_LT(balancing.step(mesh).norm(), 1e-3);
  Mesh_view moved = inverted(mesh, {.1, .05, .08});
  for (int i = 0; i < 12; ++i) moved.set_positions(balancing.balanced(moved));
  EXPECT_LT(balancing.step(moved).norm(), 1e-3);
  EXPECT_NEAR(balancing.imbalance(moved), balancing.imbalance(mesh), 1e-3);
}

TEST(Canonical_metric, refuses_spheres)
{
  EXPECT_THROW(canonical_density(icosphere(1)), CGP::Precondition_error);
}

}  // namespace cgp_test::canonical_area_density_tests
