// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <utility>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// Willmore flow, rho = -tau H on the vertices: the loop that flows consist of
class Willmore_flow {
 public:
  /// \param tolerance of the eigenvectors
  Willmore_flow(const CGP::Mesh_view& mesh, double tolerance, const CGP::Spin_solvers& solvers = {})
      : m_mesh(mesh), m_transformation(mesh, with(tolerance, solvers))
  {}

  /// curvature, matrices, factors, eigenvector, positions and certificate, as a step of a flow
  CGP::Spin_report step(double tau)
  {
    m_transformation.set_positions(m_mesh.positions());
    CGP::Spin_result result = m_transformation.closed_step(-tau * CGP::mean_curvature(m_mesh));
    m_mesh.set_positions(std::move(result.positions));
    return result.report;
  }

 private:
  static CGP::Spin_transformation_options with(double tolerance, const CGP::Spin_solvers& solvers)
  {
    CGP::Spin_transformation_options options;
    options.dirac.tolerance = tolerance;
    options.solvers = solvers;
    return options;
  }

  CGP::Mesh_view m_mesh;
  CGP::Spin_transformation m_transformation;
};

}  // namespace cgp_benchmark
