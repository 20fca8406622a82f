// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_parameterization.h>

#include <gtest/gtest.h>

#include <boost/property_map/property_map.hpp>

#include <complex>
#include <map>

#include "support/bounded_meshes.h"
#include "support/cgal_meshes.h"
#include "support/views.h"

/// What conformal_parameterization() does to a mesh of any type, measured against the function on
/// flat arrays.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

inline Mesh_view cap_to_map()
{
  return cap_from_disk(disk(6), 2.);
}

/// the same points as for the view of the mesh
template <class Mesh>
void expect_parameterization_of_the_view(const Mesh& mesh, double tolerance)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  const auto expected = CGP::spectral_parameterization(view_of(mesh));
  std::map<Vertex, std::complex<double>> uv;
  const CGP::Parameterization_report report =
      CGP::conformal_parameterization(mesh, boost::make_assoc_property_map(uv));
  ASSERT_TRUE(report);
  EXPECT_EQ(report.conformality.flipped_faces, 0);
  EXPECT_NEAR(report.conformality.quasi_conformal.mean,
              expected.report.conformality.quasi_conformal.mean, tolerance);
  ASSERT_EQ(static_cast<Eigen::Index>(uv.size()), expected.z.size());
  Eigen::Index i = 0;
  for (const Vertex v : vertices(mesh)) EXPECT_LT(std::abs(uv[v] - expected.z[i++]), tolerance);
}

}  // namespace cgp_test
