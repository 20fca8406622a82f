// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// A solver of one's own.
#include <Conformal_geometry_processing/spin_transform.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

namespace CGP = Conformal_geometry_processing;

struct My_solver_traits {
  template <class Scalar>
  struct Solver : CGP::Supernodal_cholesky<Scalar> {};
};

int main(int argc, char* argv[])
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  if (argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) return 1;
  auto rho = mesh.add_property_map<CGAL::SM_Vertex_index, double>("v:rho").first;
  for (auto v : vertices(mesh)) rho[v] = mesh.point(v).x();
  const auto report =
      CGP::spin_transform(mesh, rho, CGP::parameters::sparse_solver(My_solver_traits()));
  return report && CGAL::IO::write_polygon_mesh(argv[2], mesh) ? 0 : 1;
}
