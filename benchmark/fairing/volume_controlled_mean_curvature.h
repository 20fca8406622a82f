// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include "Fairing_flow.h"
#include "Real_cholesky.h"
#include "laplacian.h"

namespace cgp_benchmark {

/// the derivative of the enclosed volume by the positions, 3 x |V|: the normal times the area of
/// each vertex
inline CGP::Points volume_gradient(const CGP::Mesh_view& mesh)
{
  CGP::Points gradient = CGP::Points::Zero(3, mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (const int v : mesh.corners(f)) gradient.col(v) += mesh.double_area_vector(f) / 6;
  return gradient;
}

/// \brief df/dt = -(H - mean of H) N by backward Euler, (M + tau / 2 L) f' = M f + c A, where A is
/// the gradient of the volume and c such that the volume stays as it is [EPT+07].
///
/// That is exact: f' = p + c q from two solutions, and c is a zero of a cubic polynomial.
class Volume_controlled_mean_curvature : public Flow_of_positions {
 public:
  Volume_controlled_mean_curvature(const CGP::Mesh_view& mesh, double time_step)
      : Flow_of_positions(mesh, time_step),
        m_matrix(CGP::vertex_graph(mesh)),
        m_solver(m_matrix.pattern(), mesh.positions())
  {}

  bool step() override
  {
    const Eigen::VectorXd M = CGP::voronoi_areas(mesh());
    assemble_implicit_step(mesh(), M, time_step() / 2, CGP::cotan_weights(mesh()), m_matrix);
    m_solver.factorize(m_matrix);
    const CGP::Points p = m_solver.solve(weighted(M, mesh().positions()));
    const CGP::Points q = m_solver.solve(volume_gradient(mesh()));
    const double volume = CGP::signed_volume(mesh());
    set_positions(p);
    const int newton_steps = 6;
    for (int i = 0; i < newton_steps; ++i) {
      const double slope = volume_gradient(mesh()).cwiseProduct(q).sum();
      const double c = (volume - CGP::signed_volume(mesh())) / slope;
      set_positions(mesh().positions() + c * q);
    }
    return true;
  }

 private:
  CGP::Hermitian_sparse_matrix<double> m_matrix;
  Real_cholesky m_solver;
};

}  // namespace cgp_benchmark
