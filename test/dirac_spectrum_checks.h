// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/dirac_spectrum.h>
#include <Conformal_geometry_processing/dirac_sphere.h>

#include <gtest/gtest.h>

#include "support/cgal_meshes.h"
#include "support/spheres.h"

/// What dirac_spectrum() and dirac_sphere() do on a mesh of any type, measured against the kernels
/// on flat arrays.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

template <class Mesh>
Mesh_view current_view(const Mesh& mesh)
{
  return CGP::Graph_view<Mesh>(mesh, CGP::parameters::default_values(), "test").view();
}

/// the eigenvalues of a surface without boundary
template <class Mesh>
void expect_spectrum_of_the_view(const Mesh& mesh)
{
  const Mesh_view view = current_view(mesh);
  const CGP::internal::Dirac_spectrum s = CGP::dirac_spectrum(mesh, 5);
  ASSERT_TRUE(s.converged);
  ASSERT_EQ(s.size(), 5);
  const CGP::internal::Dirac_spectrum expected =
      CGP::internal::Dirac_spectral_problem(view).find(CGP::no_potential(view), 5);
  EXPECT_LT((s.eigenvalues - expected.eigenvalues).cwiseAbs().maxCoeff(), 1e-9);
}

/// \param mesh a round sphere
/// \param accuracy of its coordinates
template <class Mesh>
void expect_dirac_sphere(Mesh mesh, double accuracy)
{
  const CGP::Spin_result expected = CGP::spin_to_dirac_sphere(current_view(mesh), 2, 0);
  ASSERT_TRUE(expected.report);
  EXPECT_TRUE(CGP::dirac_sphere(mesh, 2, 0));
  const CGP::Points moved = current_view(mesh).positions();
  EXPECT_LT((moved - expected.positions).cwiseAbs().maxCoeff(), accuracy);
}

}  // namespace cgp_test
