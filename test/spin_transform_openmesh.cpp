// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin_transform.h, dirac_spectrum.h, dirac_sphere.h
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// CGAL's header comes after OpenMesh's.
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include "dirac_spectrum_checks.h"
#include "spin_transform_boundary_checks.h"

namespace cgp_test::spin_transform_openmesh_tests {

struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Surface = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

TEST(Spin_transform_of_an_OpenMesh, is_that_of_its_triangles)
{
  // CGAL 5.5 writes the points of OpenMesh through float.
  cgp_test::expect_transformation(cgp_test::to_cgal_mesh<Surface>(cgp_test::sphere_to_transform()),
                                  1e-6);
}

TEST(Spin_transform_of_an_OpenMesh, prescribes_what_becomes_of_the_boundary)
{
  cgp_test::expect_transformation_with_boundary(
      cgp_test::to_cgal_mesh<Surface>(cgp_test::cap_to_transform()), 1e-6);
}

TEST(Dirac_spectrum_of_an_OpenMesh, is_that_of_its_triangles)
{
  cgp_test::expect_spectrum_of_the_view(cgp_test::to_cgal_mesh<Surface>(cgp_test::bumpy_sphere(2)));
}

TEST(Dirac_sphere_of_an_OpenMesh, is_that_of_its_triangles)
{
  cgp_test::expect_dirac_sphere(cgp_test::to_cgal_mesh<Surface>(cgp_test::icosphere(3)), 1e-6);
}

}  // namespace cgp_test::spin_transform_openmesh_tests
