// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests flow/Fairing_patch.h
#include <Conformal_geometry_processing/flow/Fairing_patch.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <gtest/gtest.h>

#include "fairing_tools.h"
#include "support/bounded_meshes.h"
#include "support/random.h"
#include "support/spheres.h"
#include "support/tori.h"

namespace cgp_test::bending_energy_tests {

using CGP::internal::Bending_energy;
using CGP::internal::Bending_matrix;
using CGP::internal::Fairing_patch;

/// a way for each free vertex, the others stay
Points random_way(const Fairing_patch& patch, std::uint64_t seed)
{
  Random random(seed);
  Points d = Points::Zero(3, patch.mesh().size_of_vertices());
  for (int k = 0; k < patch.size(); ++k) d.col(patch.free_vertex(k)) = random.vector();
  return d;
}

std::vector<char> upper_part(const Mesh_view& mesh)
{
  return region_where(mesh, [](const auto& c) { return c.z() > .2; });
}

TEST(Bending_energy, is_that_of_a_cap_of_a_sphere)
{
  // On the unit sphere, with the vertices on it: H^2 = 1, so the energy is an area.
  for (const int frequency : {8, 16, 32}) {
    const Mesh_view mesh = geodesic_sphere(frequency);
    const Fairing_patch patch(mesh, upper_part(mesh), "f");
    const Bending_energy energy(patch, patch.mesh().positions());
    double area = 0;
    for (int v = 0; v < patch.mesh().size_of_vertices(); ++v)
      if (patch.bends(v)) area += energy.areas()[v];
    EXPECT_NEAR(energy.value() / area, 1, 1e-3 * 64 / (frequency * frequency));
  }
}

TEST(Bending_energy, is_the_willmore_energy_of_the_whole_where_it_bends)
{
  const Mesh_view mesh = torus(2, 1, 40, 20);
  std::vector<char> region(at(mesh.size_of_faces()), 1);
  region[0] = 0;
  const Fairing_patch patch(mesh, region, "f");
  EXPECT_NEAR(Bending_energy(patch, patch.mesh().positions()).value(), CGP::willmore_energy(mesh),
              1e-2 * CGP::willmore_energy(mesh));
}

TEST(Bending_energy, has_the_exact_derivative)
{
  for (const Mesh_view& mesh :
       {perturbed(icosphere(2), .02), perturbed(icosphere(2), .2), irregular_torus(2, 1, 20, 10)}) {
    const Fairing_patch patch(mesh, upper_part(mesh), "f");
    const Points f = patch.mesh().positions(), g = Bending_energy(patch, f).gradient();
    for (const std::uint64_t seed : {1, 2, 3}) {
      const Points d = random_way(patch, seed);
      const double h = 1e-6;
      const double difference =
          (Bending_energy(patch, f + h * d).value() - Bending_energy(patch, f - h * d).value()) /
          (2 * h);
      EXPECT_NEAR(g.cwiseProduct(d).sum(), difference, 1e-5 * g.norm() * d.norm());
    }
    for (int v = 0; v < f.cols(); ++v) EXPECT_TRUE(patch.is_free(v) || g.col(v).isZero(0));
  }
}

TEST(Bending_energy, does_not_depend_on_similarities)
{
  const Mesh_view mesh = perturbed(icosphere(2), .05);
  const Fairing_patch patch(mesh, upper_part(mesh), "f");
  const Points f = patch.mesh().positions();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()).toRotationMatrix();
  EXPECT_NEAR(Bending_energy(patch, 7 * turn * f).value(), Bending_energy(patch, f).value(), 1e-11);
}

TEST(Bending_matrix, is_the_second_derivative_of_the_energy_of_a_plane)
{
  // Of a plane, moved by t phi along its normal, the energy is t^2 <phi, K phi> / 2 + O(t^4).
  const Mesh_view plane = jittered_disk(6, .3);
  const Fairing_patch patch(plane, std::vector<char>(at(plane.size_of_faces()), 1), "f");
  const Points f = patch.mesh().positions();
  const Bending_energy energy(patch, f);
  const Bending_matrix bending(patch);
  CGP::Hermitian_sparse_matrix<double> K(bending.pattern());
  bending.assemble(energy, [&](int k, double x) { K.value(k) += x; });
  Points d = random_way(patch, 5);
  d.topRows<2>().setZero();
  Eigen::VectorXd phi(patch.size());
  for (int k = 0; k < patch.size(); ++k) phi[k] = d(2, patch.free_vertex(k));
  const double t = 1e-5, expected = phi.dot(K * phi) / 2;
  EXPECT_GT(expected, 1);
  EXPECT_NEAR(Bending_energy(patch, f + t * d).value() / (t * t), expected, 1e-4 * expected);
  EXPECT_LT(energy.value(), 1e-20);
}

}  // namespace cgp_test::bending_energy_tests
