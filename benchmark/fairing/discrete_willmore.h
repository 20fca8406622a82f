// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include "Bi_laplacian.h"
#include "Fairing_flow.h"
#include "Real_cholesky.h"
#include "circle_angle_energy.h"

namespace cgp_benchmark {

/// \brief The gradient flow of the energy of circle angles [BS05], semi-implicit:
/// (M + times tau / 2 L M^-1 L) (f' - f) = -tau grad W.
///
/// The gradient is exact. The Hessian of W is replaced by that of the smooth energy for a fixed
/// metric, which is positive semidefinite. On equilateral triangles W is 3 / 2 of the smooth
/// energy, and its Hessian is unbounded if circles nearly coincide: a multiple allows larger steps.
template <int times>
class Discrete_willmore : public Flow_of_positions {
 public:
  Discrete_willmore(const CGP::Mesh_view& mesh, double time_step)
      : Flow_of_positions(mesh, time_step),
        m_operator(mesh),
        m_solver(m_operator.pattern(), mesh.positions())
  {}

  bool step() override
  {
    const Eigen::VectorXd M = CGP::voronoi_areas(mesh());
    m_solver.factorize(m_operator.assemble(M, times * time_step() / 2, CGP::cotan_weights(mesh())));
    set_positions(mesh().positions() - m_solver.solve(time_step() * circle_angle_gradient(mesh())));
    return true;
  }

 private:
  Bi_laplacian m_operator;
  Real_cholesky m_solver;
};

}  // namespace cgp_benchmark
