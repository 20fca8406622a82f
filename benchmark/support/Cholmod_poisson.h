// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

#include <cholmod.h>

#include <algorithm>
#include <stdexcept>

#include "clock.h"

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// \brief The yardstick P: one scalar Poisson problem by CHOLMOD with default options,
/// called directly.
///
/// The cotan Laplacian is assembled in place and passed without a copy; CHOLMOD chooses ordering
/// and kind of factorization; three right-hand sides are solved at once. This is a lower bound for
/// all known methods for a spin transformation.
class Cholmod_poisson {
 public:
  explicit Cholmod_poisson(const CGP::Mesh_view& mesh)
      : m_matrix(CGP::cotan_laplacian(mesh, CGP::vertex_graph(mesh)))
  {
    cholmod_start(&m_common);
    m_common.print = 0;
    // The Laplacian kills the constants: vertex 0 is fixed, row and column 0 are the identity's.
    for (int k = 0; k < m_matrix.pattern().offsets[1]; ++k) m_matrix.value(k) = k == 0 ? 1 : 0;
    const CGP::Sparse_pattern& pattern = m_matrix.pattern();
    m_view.nrow = m_view.ncol = static_cast<std::size_t>(pattern.size());
    m_view.nzmax = pattern.indices.size();
    m_view.p = const_cast<int*>(pattern.offsets.data());
    m_view.i = const_cast<int*>(pattern.indices.data());
    m_view.x = &m_matrix.value(0);
    m_view.stype = -1;
    m_view.itype = CHOLMOD_INT;
    m_view.xtype = CHOLMOD_REAL;
    m_view.dtype = CHOLMOD_DOUBLE;
    m_view.sorted = m_view.packed = 1;
  }
  Cholmod_poisson(const Cholmod_poisson&) = delete;
  Cholmod_poisson& operator=(const Cholmod_poisson&) = delete;
  ~Cholmod_poisson()
  {
    cholmod_free_factor(&m_factor, &m_common);
    cholmod_finish(&m_common);
  }

  void analyze()
  {
    m_factor = cholmod_analyze(&m_view, &m_common);
    if (m_factor == nullptr) throw std::runtime_error("CHOLMOD cannot analyze the Laplacian");
  }

  void factorize()
  {
    if (!cholmod_factorize(&m_view, m_factor, &m_common) || m_common.status != CHOLMOD_OK)
      throw std::runtime_error("CHOLMOD cannot factorize the Laplacian");
  }

  Eigen::MatrixXd solve(Eigen::MatrixXd b)
  {
    b.row(0).setZero();
    cholmod_dense view{};
    view.nrow = view.d = static_cast<std::size_t>(b.rows());
    view.ncol = static_cast<std::size_t>(b.cols());
    view.nzmax = view.nrow * view.ncol;
    view.x = b.data();
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, m_factor, &view, &m_common);
    if (x == nullptr) throw std::runtime_error("CHOLMOD cannot solve with the Laplacian");
    b = Eigen::Map<Eigen::MatrixXd>(static_cast<double*>(x->x), b.rows(), b.cols());
    cholmod_free_dense(&x, &m_common);
    return b;
  }

  bool is_supernodal() const { return m_factor->is_super != 0; }

 private:
  CGP::Hermitian_sparse_matrix<double> m_matrix;
  cholmod_common m_common;
  cholmod_sparse m_view{};
  cholmod_factor* m_factor = nullptr;
};

/// the least seconds of the processor for each stage of P, and for all of P
struct Poisson_seconds {
  double assembly = never, analysis = never, numeric = never, again = never, solve = never;
  double total = never;

  /// does it once more
  void measure(const CGP::Mesh_view& mesh)
  {
    const double begin = cpu_seconds();
    Cholmod_poisson poisson(mesh);
    const double assembled = cpu_seconds();
    poisson.analyze();
    const double analyzed = cpu_seconds();
    poisson.factorize();
    const double factorized = cpu_seconds();
    if (!poisson.solve(mesh.positions().transpose()).allFinite())
      throw std::runtime_error("CHOLMOD's solution is not finite");
    const double end = cpu_seconds();
    assembly = std::min(assembly, assembled - begin);
    analysis = std::min(analysis, analyzed - assembled);
    numeric = std::min(numeric, factorized - analyzed);
    solve = std::min(solve, end - factorized);
    total = std::min(total, end - begin);
    keep_least(again, [&] { poisson.factorize(); });
  }
};

}  // namespace cgp_benchmark
