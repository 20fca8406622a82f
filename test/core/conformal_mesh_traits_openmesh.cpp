// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Conformal_mesh_traits.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "core/conformal_mesh_traits_checks.h"
#include "support/cgal_meshes.h"
#include "support/meshes.h"

namespace cgp_test::conformal_mesh_traits_openmesh_tests {

TEST(Conformal_mesh_traits_of_an_OpenMesh, supply_maps_with_initial_values)
{
  using Surface = OpenMesh::TriMesh_ArrayKernelT<>;
  auto mesh = cgp_test::to_cgal_mesh<Surface>(cgp_test::icosphere(1));
  cgp_test::expect_initial_values(mesh);
  cgp_test::expect_shared_values(mesh);
  cgp_test::expect_maps_to_outlive_the_traits(mesh);
}

}  // namespace cgp_test::conformal_mesh_traits_openmesh_tests
