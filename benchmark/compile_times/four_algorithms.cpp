// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Four algorithms in one program.
#include <Conformal_geometry_processing/conformal_parameterization.h>
#include <Conformal_geometry_processing/conformal_willmore_flow.h>
#include <Conformal_geometry_processing/harmonic_basis.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

namespace CGP = Conformal_geometry_processing;
using Kernel = CGAL::Simple_cartesian<double>;

int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) return 1;
  auto rho = mesh.add_property_map<CGAL::SM_Vertex_index, double>("v:rho").first;
  auto uv = mesh.add_property_map<CGAL::SM_Vertex_index, Kernel::Point_2>("v:uv").first;
  for (auto v : vertices(mesh)) rho[v] = mesh.point(v).x();
  const bool is_good = CGP::spin_transform(mesh, rho) && CGP::conformal_willmore_flow(mesh) &&
                       CGP::conformal_parameterization(mesh, uv);
  const auto basis = CGP::harmonic_basis(mesh);
  return is_good && basis.size() >= 0 && CGAL::IO::write_polygon_mesh(argv[2], mesh) ? 0 : 1;
}
