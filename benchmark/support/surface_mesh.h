// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

inline Vertex vertex(int v)
{
  return Vertex(static_cast<unsigned>(v));
}

inline Point point(const Eigen::Vector3d& p)
{
  return {p.x(), p.y(), p.z()};
}

inline Mesh surface_mesh(const CGP::Mesh_view& view)
{
  Mesh mesh;
  for (int v = 0; v < view.size_of_vertices(); ++v) mesh.add_vertex(point(view.position(v)));
  for (const auto& [a, b, c] : view.corners()) mesh.add_face(vertex(a), vertex(b), vertex(c));
  return mesh;
}

inline CGP::Points positions(const Mesh& mesh)
{
  CGP::Points p(3, static_cast<Eigen::Index>(mesh.number_of_vertices()));
  for (const Vertex v : vertices(mesh))
    p.col(static_cast<Eigen::Index>(v.idx())) << mesh.point(v).x(), mesh.point(v).y(),
        mesh.point(v).z();
  return p;
}

}  // namespace cgp_benchmark
