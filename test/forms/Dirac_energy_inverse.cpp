// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests forms/Dirac_energy_inverse.h
#include <Conformal_geometry_processing/forms/Dirac_energy_inverse.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <gtest/gtest.h>

#include <limits>

#include "support/dirac_sources.h"
#include "support/meshes.h"

// `test/spin/Dirac_system_response.cpp` tests it with the factor that it is made for.
using namespace cgp_test;

TEST(Dirac_energy_inverse, takes_the_factor_of_the_eigenvalue_problem_for_any_rho)
{
  const Mesh_view mesh = btorus(12);
  const auto X = CGP::dirac_energy(mesh, CGP::no_potential(mesh));
  const Quaternion_matrix c = sources(mesh.size_of_vertices(), 3);
  for (const double amplitude : {0., 0.2}) {
    CGP::internal::Dirac_system<> problem(mesh);
    CGP::internal::Dirac_solution::Seconds seconds;
    CGP::Curvature_potential rho = CGP::no_potential(mesh);
    rho.values = amplitude * random_numbers(mesh.size_of_vertices(), 5);
    problem.set_potential(rho, seconds);
    const CGP::internal::Dirac_energy_inverse inverse(X, problem.areas(), problem.solver());
    expect_solutions(mesh, inverse(c), c);
  }
}

TEST(Dirac_energy_inverse, gives_up_on_values_that_are_not_finite)
{
  const Mesh_view mesh = btorus(8);
  CGP::internal::Dirac_system<> system(mesh);
  system.prepare_response();
  const CGP::internal::Dirac_energy_inverse inverse(system.matrix(), system.areas(),
                                                    system.solver());
  Quaternion_matrix c = sources(mesh.size_of_vertices(), 1);
  c(3, 0).y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)inverse(c), CGP::Solver_error);
}
