// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/moebius_transform.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "moebius_transform_checks.h"

namespace cgp_test::moebius_transform_openmesh_tests {

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

TEST(Moebius_transform_of_an_OpenMesh, moves_each_vertex_by_the_map)
{
  // CGAL 5.5 writes the points of OpenMesh through float.
  cgp_test::expect_moebius_transforms(cgp_test::to_cgal_mesh<Surface>(cgp_test::sphere_to_invert()),
                                      1e-4);
}

}  // namespace cgp_test::moebius_transform_openmesh_tests
