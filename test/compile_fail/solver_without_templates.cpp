// expect: needs #include <Conformal_geometry_processing/templates.h>
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/multigrid/Multigrid_solver.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

int main()
{
  namespace CGP = Conformal_geometry_processing;
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  auto rho = mesh.add_property_map<CGAL::SM_Vertex_index, double>("v:rho").first;
  return CGP::spin_transform(mesh, rho,
                             CGP::parameters::sparse_solver(CGP::Multigrid_solver_traits()))
             ? 0
             : 1;
}
