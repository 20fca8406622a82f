// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/dirac_pencils.h
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/dirac_pencils.h>

#include "spin/boundary_tools.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::dirac_pencils_tests {

using Vectors = CGP::Block<Quaternion<double>>;

/// on a closed surface and on one with prescribed directions, whose spins are a real space
class Dirac_pencils : public testing::TestWithParam<bool> {
 protected:
  Dirac_pencils() { set_potential(rho); }

  void set_potential(const Curvature_potential& potential)
  {
    CGP::internal::Dirac_evidence::Seconds seconds;
    system.set_potential(potential, seconds);
  }

  /// a member of the space
  Vectors random_member(int seed) const
  {
    return system.projected(random_quaternions(mesh.size_of_vertices(), at(seed)));
  }

  /// M_V x
  Vectors times_masses(const Vectors& x) const { return CGP::block_operator(system.areas())(x); }

  const Mesh_view mesh = GetParam() ? perturbed(cap_from_disk(jittered_disk(4, .3), 1), .04)
                                    : radially_perturbed(icosphere(2), .1);
  const Curvature_potential rho =
      potential_on_faces(mesh, [](const auto& p) { return std::cos(2 * p.x() + 1); });
  CGP::internal::Dirac_system system{
      mesh, GetParam() ? Boundary_condition::binormals() : Boundary_condition::free()};
  const Vectors none = Vectors(mesh.size_of_vertices(), 0);
};

double greatest(const Vectors& x)
{
  return greatest_entry(x);
}

INSTANTIATE_TEST_SUITE_P(Closed_and_bounded, Dirac_pencils, testing::Bool());

TEST_P(Dirac_pencils, have_the_constants_in_their_kernel_for_rho_zero)
{
  const Vectors constants = CGP::internal::constants_in_space(system);
  ASSERT_EQ(constants.cols(), 1);
  set_potential(CGP::no_potential(mesh));
  EXPECT_LT(greatest(CGP::block_operator(system.matrix())(constants)), 1e-12);
  EXPECT_LT(greatest(system.projected(constants) - constants), 1e-14);
  EXPECT_NEAR(system.squared_norm(constants.col(0)), 1, 1e-13);
}

TEST_P(Dirac_pencils, solve_beside_the_constants)
{
  const Vectors constants = CGP::internal::constants_in_space(system);
  set_potential(CGP::no_potential(mesh));
  const Vectors b = random_member(2), x = CGP::internal::solve_beside(system, constants, b);
  const Vectors masses = times_masses(constants);
  EXPECT_LT(greatest(CGP::gram_matrix(masses, x, system.coefficients())), 1e-12);
  Vectors expected = b;
  CGP::add_combination(expected, masses,
                       Vectors(-CGP::gram_matrix(constants, b, system.coefficients())));
  const CGP::internal::Pencil pencil = CGP::internal::pencil_of_masses(system, constants);
  EXPECT_LT(greatest(pencil.N(x) - expected), 1e-10);
  EXPECT_LT(greatest(pencil.solve(b) - x), 1e-14);
}

TEST_P(Dirac_pencils, apply_the_matrices_of_the_system)
{
  const CGP::internal::Pencil masses = CGP::internal::pencil_of_masses(system, none);
  const Vectors x = random_member(3);
  EXPECT_LT(greatest(masses.K(x) - system.projected(times_masses(x))), 1e-14);
  const Vectors shifted =
      CGP::block_operator(system.matrix())(x) + times_masses(x) * system.shift();
  EXPECT_LT(greatest(masses.N(x) - system.projected(shifted)), 1e-12);
  EXPECT_EQ(masses.coefficients, system.coefficients());
  const CGP::internal::Pencil form = CGP::internal::pencil_of_form(system, rho, none);
  const auto K = CGP::dirac_form(mesh, rho);
  EXPECT_LT(greatest(form.K(x) - system.projected(CGP::block_operator(K)(x))), 1e-13);
  EXPECT_LT(greatest(form.N(x) - masses.N(x)), 1e-15);
}

TEST_P(Dirac_pencils, solve_with_their_second_matrix)
{
  for (const CGP::internal::Pencil& pencil : {CGP::internal::pencil_of_masses(system, none),
                                              CGP::internal::pencil_of_form(system, rho, none)}) {
    const Vectors b = random_member(4), x = pencil.solve(b);
    EXPECT_LT(greatest(system.projected(x) - x), 1e-11);
    EXPECT_LT(greatest(pencil.N(x) - b), 1e-10);
  }
}

TEST_P(Dirac_pencils, have_forms_over_the_numbers_of_the_space)
{
  Vectors v(mesh.size_of_vertices(), 2);
  v << random_member(5), random_member(6);
  const CGP::internal::Dirac_forms found = CGP::internal::forms_in_space(system, rho, v),
                                   all = CGP::dirac_forms(mesh, rho, v);
  for (Eigen::Index i = 0; i < 2; ++i)
    for (Eigen::Index j = 0; j < 2; ++j) {
      const auto reduced = [&](const Quaternion<double>& q) {
        return GetParam() ? Quaternion<double>{q.w, 0, 0, 0} : q;
      };
      EXPECT_EQ(found.dirac(i, j), reduced(all.dirac(i, j)));
      EXPECT_EQ(found.mass(i, j), reduced(all.mass(i, j)));
    }
}

}  // namespace cgp_test::dirac_pencils_tests
