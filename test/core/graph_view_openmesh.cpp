// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Graph_view.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "core/graph_view_checks.h"
#include "support/cgal_meshes.h"

namespace cgp_test::graph_view_openmesh_tests {

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

// CGAL 5.5 writes the points of OpenMesh through float: the meshes here have none that round.
TEST(Graph_view_of_an_OpenMesh, has_its_triangles)
{
  expect_view_of(cube(), to_cgal_mesh<Surface>(cube()));
  expect_view_of(grid(2, 4), to_cgal_mesh<Surface>(grid(2, 4)));
}

TEST(Graph_view_of_an_OpenMesh, writes_positions_into_the_mesh)
{
  Surface mesh = to_cgal_mesh<Surface>(cube());
  expect_positions_are_written(mesh);
}

}  // namespace cgp_test::graph_view_openmesh_tests
