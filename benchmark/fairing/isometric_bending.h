// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <vector>

#include "Fairing_flow.h"
#include "Rank_one_sum.h"
#include "Real_cholesky.h"
#include "laplacian.h"

namespace cgp_benchmark {

/// \brief M + t Q, where f^T Q f is the integral of |Delta f|^2 by nonconforming elements [WBH+07]:
/// a sum over the hinges, each an edge and its two faces, of 3 / (area of both) times the square of
/// K f.
///
/// K consists of the cotangents at the ends of the edge: the coefficient of the first vertex is the
/// sum of those at the second one and vice versa, the coefficient of the opposite corner of each
/// face is minus the sum of the cotangents in this face.
class Bending_matrix {
 public:
  explicit Bending_matrix(const CGP::Mesh_view& mesh) : m_sum(mesh.size_of_vertices(), hinges(mesh))
  {}

  const CGP::Sparse_pattern& pattern() const { return m_sum.pattern(); }

  const CGP::Hermitian_sparse_matrix<double>& assemble(const CGP::Mesh_view& mesh,
                                                       const Eigen::VectorXd& M, double t)
  {
    using View = CGP::Mesh_view;
    const Eigen::VectorXd areas = CGP::face_areas(mesh);
    Eigen::VectorXd weights(mesh.size_of_edges());
    std::vector<double> K;
    for (int k = 0; k < mesh.size_of_edges(); ++k) {
      const int h = mesh.halfedges_begin(k)[0], g = mesh.twin(h);
      const double h_from = cotangent(mesh, View::next_in_face(h)),
                   h_to = cotangent(mesh, View::previous_in_face(h)),
                   g_from = cotangent(mesh, View::next_in_face(g)),
                   g_to = cotangent(mesh, View::previous_in_face(g));
      K.insert(K.end(), {h_to + g_from, h_from + g_to, -h_from - h_to, -g_from - g_to});
      weights[k] = 3 * t / (areas[View::face(h)] + areas[View::face(g)]);
    }
    return m_sum.assemble(M, weights, K);
  }

 private:
  static Stencils hinges(const CGP::Mesh_view& mesh)
  {
    Stencils stencils;
    for (int k = 0; k < mesh.size_of_edges(); ++k) {
      const int h = mesh.halfedges_begin(k)[0], g = mesh.twin(h);
      for (const int v : {mesh.from(h), mesh.to(h), mesh.to(CGP::Mesh_view::next_in_face(h)),
                          mesh.to(CGP::Mesh_view::next_in_face(g))})
        stencils.vertices.push_back(v);
      stencils.close();
    }
    return stencils;
  }

  Rank_one_sum m_sum;
};

/// the Willmore flow for which deformations are isometric: (M + tau / 2 Q) f' = M f, with the
/// metric of the surface before each step
class Isometric_bending : public Flow_of_positions {
 public:
  Isometric_bending(const CGP::Mesh_view& mesh, double time_step)
      : Flow_of_positions(mesh, time_step),
        m_operator(mesh),
        m_solver(m_operator.pattern(), mesh.positions())
  {}

  bool step() override
  {
    const Eigen::VectorXd M = CGP::voronoi_areas(mesh());
    m_solver.factorize(m_operator.assemble(mesh(), M, time_step() / 2));
    set_positions(m_solver.solve(weighted(M, mesh().positions())));
    return true;
  }

 private:
  Bending_matrix m_operator;
  Real_cholesky m_solver;
};

/// the same with the metric of the input for ever: one factorization serves all steps
class Isometric_bending_of_the_input : public Flow_of_positions {
 public:
  Isometric_bending_of_the_input(const CGP::Mesh_view& mesh, double time_step)
      : Flow_of_positions(mesh, time_step),
        m_areas(CGP::voronoi_areas(mesh)),
        m_operator(mesh),
        m_solver(m_operator.pattern(), mesh.positions())
  {
    m_solver.factorize(m_operator.assemble(mesh, m_areas, time_step / 2));
  }

  bool step() override
  {
    set_positions(m_solver.solve(weighted(m_areas, mesh().positions())));
    return true;
  }

 private:
  Eigen::VectorXd m_areas;
  Bending_matrix m_operator;
  Real_cholesky m_solver;
};

}  // namespace cgp_benchmark
