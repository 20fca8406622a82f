// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/associated_family.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <cmath>

namespace Conformal_geometry_processing {

Associated_family::Associated_family(const Mesh_view& mesh, const std::string& function,
                                     const Spin_solvers& solvers)
    : m_mesh((require_surface(mesh, function), mesh)),
      m_normals(vertex_normals(mesh, internal::Normal_weight::angle)),
      m_reconstruction(m_mesh, vertex_graph(m_mesh), solvers)
{}

internal::Associated_surface Associated_family::operator()(double theta) const
{
  Quaternion_vector<double> lambda(m_mesh.size_of_vertices());
  for (int v = 0; v < m_mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d n = std::sin(theta / 2) * m_normals.col(v);
    lambda[v] = {std::cos(theta / 2), n.x(), n.y(), n.z()};
  }
  const Eigen::MatrixX3d edges = transformed_edges(m_mesh, lambda);
  internal::Associated_surface surface;
  surface.positions = m_reconstruction.positions(edges);
  surface.closure_residual = m_reconstruction.residual(surface.positions, edges);
  return surface;
}

}  // namespace Conformal_geometry_processing
