// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_willmore_flow.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "conformal_willmore_flow_boundary_checks.h"

namespace cgp_test::conformal_willmore_flow_openmesh_tests {

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

TEST(Conformal_willmore_flow_of_an_OpenMesh, is_that_of_its_triangles)
{
  // CGAL 5.5 writes the points of OpenMesh through float.
  cgp_test::expect_flow(cgp_test::to_cgal_mesh<Surface>(cgp_test::bumpy_sphere(2)), 1e-6);
}

TEST(Conformal_willmore_flow_of_an_OpenMesh, turns_its_boundary)
{
  cgp_test::expect_flow_with_binormals(
      cgp_test::to_cgal_mesh<Surface>(cgp_test::bumpy_cap_of_few_faces()), 1e-6);
}

}  // namespace cgp_test::conformal_willmore_flow_openmesh_tests
