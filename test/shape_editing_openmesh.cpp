// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/filter_curvature.h
// Tests include/Conformal_geometry_processing/minimal_surface.h
// Tests include/Conformal_geometry_processing/nearest_spin_transform.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "shape_editing_checks.h"

namespace cgp_test::shape_editing_openmesh_tests {

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

TEST(Shape_editing_of_an_OpenMesh, is_that_of_its_triangles)
{
  // CGAL 5.5 writes the points of OpenMesh through float.
  expect_nearest_transformation(to_cgal_mesh<Surface>(icosphere(2)), 1e-6);
  expect_minimal_surface(to_cgal_mesh<Surface>(cap_to_flatten()), 1e-6);
  expect_filtered_curvature(to_cgal_mesh<Surface>(icosphere(2)));
}

}  // namespace cgp_test::shape_editing_openmesh_tests
