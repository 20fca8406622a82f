// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/harmonic_basis.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "harmonic_basis_checks.h"

namespace cgp_test::harmonic_basis_openmesh_tests {

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

TEST(Harmonic_basis_of_an_OpenMesh, is_that_of_its_triangles)
{
  expect_harmonic_forms(to_cgal_mesh<Surface>(holed_block(2)), 2);
  expect_basis_of_the_view(to_cgal_mesh<Surface>(btorus(8)));
}

}  // namespace cgp_test::harmonic_basis_openmesh_tests
