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
  explicit Willmore_flow(const CGP::Mesh_view& mesh, const CGP::Spin_solvers& solvers = {})
      : m_mesh(mesh), m_transformation(mesh, with(solvers))
  {}

  /// curvature, matrices, factors, eigenvector, positions and certificate
  CGP::Spin_report step(double tau, const CGP::Dirac_options& options = {})
  {
    m_transformation.set_positions(m_mesh.positions());
    CGP::Spin_result result = m_transformation.transform(
        CGP::Curvature_potential::on_vertices(-tau * CGP::mean_curvature(m_mesh)), options);
    m_mesh.set_positions(std::move(result.positions));
    return result.report;
  }

 private:
  static CGP::Spin_transformation_options with(const CGP::Spin_solvers& solvers)
  {
    CGP::Spin_transformation_options options;
    options.solvers = solvers;
    return options;
  }

  CGP::Mesh_view m_mesh;
  CGP::Spin_transformation m_transformation;
};

}  // namespace cgp_benchmark
