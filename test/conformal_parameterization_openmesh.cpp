// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_parameterization.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "conformal_parameterization_checks.h"

namespace cgp_test::conformal_parameterization_openmesh_tests {

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

TEST(Conformal_parameterization_of_an_OpenMesh, is_that_of_its_triangles)
{
  expect_parameterization_of_the_view(to_cgal_mesh<Surface>(cap_to_map()), 1e-12);
}

}  // namespace cgp_test::conformal_parameterization_openmesh_tests
