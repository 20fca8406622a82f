// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include "Fairing_flow.h"
#include "Real_cholesky.h"
#include "laplacian.h"

namespace cgp_benchmark {

/// the mean curvature flow by backward Euler with the metric of the surface before the step:
/// (M + tau / 2 L) f' = M f [DMSB99]
class Implicit_mean_curvature : public Flow_of_positions {
 public:
  Implicit_mean_curvature(const CGP::Mesh_view& mesh, double time_step)
      : Flow_of_positions(mesh, time_step),
        m_matrix(CGP::vertex_graph(mesh)),
        m_solver(m_matrix.pattern(), mesh.positions())
  {}

  bool step() override
  {
    const Eigen::VectorXd M = CGP::voronoi_areas(mesh());
    assemble_implicit_step(mesh(), M, time_step() / 2, CGP::cotan_weights(mesh()), m_matrix);
    m_solver.factorize(m_matrix);
    set_positions(m_solver.solve(weighted(M, mesh().positions())));
    return true;
  }

 private:
  CGP::Hermitian_sparse_matrix<double> m_matrix;
  Real_cholesky m_solver;
};

}  // namespace cgp_benchmark
