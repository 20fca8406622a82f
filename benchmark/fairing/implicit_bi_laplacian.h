// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include "Bi_laplacian.h"
#include "Fairing_flow.h"
#include "Real_cholesky.h"
#include "laplacian.h"

namespace cgp_benchmark {

/// the flow of the bi-Laplacian by backward Euler with the metric of the surface before the step:
/// (M + tau / 2 L M^-1 L) f' = M f
class Implicit_bi_laplacian : public Flow_of_positions {
 public:
  Implicit_bi_laplacian(const CGP::Mesh_view& mesh, double time_step)
      : Flow_of_positions(mesh, time_step),
        m_operator(mesh),
        m_solver(m_operator.pattern(), mesh.positions())
  {}

  bool step() override
  {
    const Eigen::VectorXd M = CGP::voronoi_areas(mesh());
    m_solver.factorize(m_operator.assemble(M, time_step() / 2, CGP::cotan_weights(mesh())));
    set_positions(m_solver.solve(weighted(M, mesh().positions())));
    return true;
  }

 private:
  Bi_laplacian m_operator;
  Real_cholesky m_solver;
};

}  // namespace cgp_benchmark
