// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_ASSOCIATED_FAMILY_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_ASSOCIATED_FAMILY_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <cmath>
#include <memory>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// a member of the family, and how far its edges are from fitting together
struct Associated_surface {
  Points positions;             ///< 3 x |V|, with mean zero
  double closure_residual = 0;  ///< relative; tends to zero where the surface is minimal and simply
                                ///< connected
};

/// \ingroup PkgSurfaces
/// \brief the isometric deformations of a minimal surface: df_theta = cos(theta) df + sin(theta)
/// df x N, catenoids into helicoids.
///
/// They are spin transformations, by lambda = cos(theta/2) + sin(theta/2) N: with H = 0 the normal
/// is in the kernel of D, as 1 is. The Laplacian is factored once, and each angle costs a solve.
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class SolverTraits = Default_solver_traits>
class Associated_family {
 public:
  /// \param mesh a minimal surface; is copied
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with finite
  /// coordinates and positive areas
  /// \throw Solver_error if the Laplacian cannot be factored
  explicit Associated_family(const Mesh_view& mesh,
                             const std::string& function = "Associated_family")
      : m_mesh((require_surface(mesh, function), mesh)),
        m_normals(vertex_normals(mesh, Normal_weight::angle)),
        m_reconstruction(m_mesh, vertex_graph(m_mesh))
  {}

  Associated_family(const Associated_family&) = delete;
  Associated_family& operator=(const Associated_family&) = delete;

  /// \param theta in radians; half a turn gives the mirror image in a point
  Associated_surface operator()(double theta) const
  {
    Quaternion_vector<double> lambda(m_mesh.size_of_vertices());
    for (int v = 0; v < m_mesh.size_of_vertices(); ++v) {
      const Eigen::Vector3d n = std::sin(theta / 2) * m_normals.col(v);
      lambda[v] = {std::cos(theta / 2), n.x(), n.y(), n.z()};
    }
    const Eigen::MatrixX3d edges = transformed_edges(m_mesh, lambda);
    Associated_surface surface;
    surface.positions = m_reconstruction.positions(edges);
    surface.closure_residual = m_reconstruction.residual(surface.positions, edges);
    return surface;
  }

 private:
  Mesh_view m_mesh;
  Points m_normals;
  Poisson_reconstruction<SolverTraits> m_reconstruction;
};

}  // namespace Conformal_geometry_processing

#endif
