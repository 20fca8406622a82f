// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include "Fairing_flow.h"
#include "Real_cholesky.h"
#include "laplacian.h"

namespace cgp_benchmark {

/// \brief the same with the Laplacian of the input and the areas of the surface before the step:
/// (M + tau / 2 L_0) f' = M f [KSBC12].
///
/// With barycentric areas, as in CGAL's `smooth_shape()`, of which it must agree with every step.
class Modified_mean_curvature : public Flow_of_positions {
 public:
  Modified_mean_curvature(const CGP::Mesh_view& mesh, double time_step)
      : Flow_of_positions(mesh, time_step),
        m_weights(CGP::cotan_weights(mesh)),
        m_matrix(CGP::vertex_graph(mesh)),
        m_solver(m_matrix.pattern(), mesh.positions())
  {}

  bool step() override
  {
    const Eigen::VectorXd M = CGP::vertex_areas(mesh());
    assemble_implicit_step(mesh(), M, time_step() / 2, m_weights, m_matrix);
    m_solver.factorize(m_matrix);
    set_positions(m_solver.solve(weighted(M, mesh().positions())));
    return true;
  }

 private:
  Eigen::VectorXd m_weights;
  CGP::Hermitian_sparse_matrix<double> m_matrix;
  Real_cholesky m_solver;
};

}  // namespace cgp_benchmark
