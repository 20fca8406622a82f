// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin_transform.h, conformal_willmore_flow.h
// Tests conformal_parameterization.h, core/Graph_view.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "components_checks.h"

namespace cgp_test::components_openmesh_tests {

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

TEST(Components_of_an_OpenMesh, spin_as_they_do_alone)
{
  expect_spins_as_alone<Surface>();
}

TEST(Components_of_an_OpenMesh, flow_as_they_do_alone)
{
  expect_flows_as_alone<Surface>();
}

TEST(Components_of_an_OpenMesh, are_flattened_as_they_are_alone)
{
  expect_flat_images_as_alone<Surface>();
}

}  // namespace cgp_test::components_openmesh_tests
