// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/canonical_metric.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "canonical_metric_checks.h"

namespace cgp_test::canonical_metric_openmesh_tests {

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

TEST(Canonical_metric_of_an_OpenMesh, is_that_of_its_triangles)
{
  // CGAL 5.5 writes the points of OpenMesh through float.
  Surface mesh = cgp_test::to_cgal_mesh<Surface>(cgp_test::torus_to_measure());
  cgp_test::expect_canonical_metric(mesh, 1e-5);
}

}  // namespace cgp_test::canonical_metric_openmesh_tests
