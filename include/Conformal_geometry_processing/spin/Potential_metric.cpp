// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Potential_metric.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/sheet_loops.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// 1 - C D^-1 C^T for positive D, by its lower triangle
inline Hermitian_sparse_matrix<double> less_outer_products(const Eigen::SparseMatrix<double>& C,
                                                           const Eigen::VectorXd& D)
{
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < C.rows(); ++v) entries.emplace_back(v, v, 1);
  for (int f = 0; f < C.cols(); ++f)
    for (Entry column(C, f); column; ++column)
      for (Entry row = column; row; ++row)
        entries.emplace_back(row.row(), column.row(), -row.value() * column.value() / D[f]);
  Eigen::SparseMatrix<double> lower(C.rows(), C.rows());
  lower.setFromTriplets(entries.begin(), entries.end());
  auto pattern = std::make_shared<Sparse_pattern>();
  pattern->offsets.assign(lower.outerIndexPtr(), lower.outerIndexPtr() + lower.cols() + 1);
  pattern->indices.assign(lower.innerIndexPtr(), lower.innerIndexPtr() + lower.nonZeros());
  Hermitian_sparse_matrix<double> matrix(std::move(pattern));
  for (int k = 0; k < lower.nonZeros(); ++k) matrix.value(k) = lower.valuePtr()[k];
  return matrix;
}

Potential_metric::Potential_metric(const Dirac_system& system, Curvature_potential::On on, double s,
                                   Factor factor)
    : m_surface(system.surface()),
      m_areas(curvature_areas(system.surface(), on)),
      m_solver(system.solver().another<double>())
{
  if (on == Curvature_potential::On::vertices) {
    m_matrix = Hermitian_sparse_matrix<double>(system.matrix().shared_pattern());
    assemble_on_vertices(system.surface(), s);
    check(m_solver.analyze_like(m_matrix.pattern(), system.solver()));
    if (factor == Factor::now) check(m_solver.factorize(m_matrix, {}));
  } else {
    assemble_on_faces(system.surface(), s);
    const auto complement = less_outer_products(m_shares, m_diagonal);
    check(m_solver.analyze(complement.pattern()));
    if (factor == Factor::now) check(m_solver.factorize(complement, {}));
  }
}

void Potential_metric::couple(const Quaternion_vector<double>& lambda, double alpha)
{
  if (m_diagonal.size() == 0)
    couple_on_vertices(lambda, alpha);
  else
    couple_on_faces(lambda, alpha);
}

void Potential_metric::couple_on_vertices(const Quaternion_vector<double>& lambda, double alpha)
{
  Hermitian_sparse_matrix<double> H = m_matrix;
  for_each_owned_range(H.size(), [&](const Index_range& own) {
    for_each_sheet_at(own, m_surface, [&](const Sheet& sheet) {
      const double c = alpha * sheet.share * sheet.area / 9;
      const auto entry = [&](int i, int j) {
        return c * dot(lambda[sheet.corners[static_cast<std::size_t>(i)]],
                       lambda[sheet.corners[static_cast<std::size_t>(j)]]);
      };
      add_sheet(sheet, own, entry, H);
    });
  });
  check(m_solver.factorize(H, {}));
}

void Potential_metric::couple_on_faces(const Quaternion_vector<double>& lambda, double alpha)
{
  m_solved_diagonal = m_diagonal;
  for (int s = 0; s < m_surface.size_of_sheets(); ++s) {
    const Sheet sheet = m_surface.sheet(s);
    Quaternion<double> sum;
    for (const int v : sheet.corners) sum += lambda[v];
    m_solved_diagonal[sheet.face] += alpha * sheet.share * sheet.area / 9 * dot(sum, sum);
  }
  check(m_solver.factorize(less_outer_products(m_shares, m_solved_diagonal), {}));
}

void Potential_metric::assemble_on_vertices(const Surface_ref& surface, double s)
{
  assemble_cotan_laplacian(surface, s * cotan_weights(surface), m_matrix);
  for (int v = 0; v < m_matrix.size(); ++v)
    m_matrix.value(diagonal_position(m_matrix.pattern(), v)) += m_areas[v];
}

// K = D - C^T C with the diagonal D and the shares C, and by Woodbury's formula
// K^-1 = D^-1 + D^-1 C^T (1 - C D^-1 C^T)^-1 C D^-1.
void Potential_metric::assemble_on_faces(const Surface_ref& surface, double s)
{
  const double factor = 3 * std::sqrt(3.) * s;
  const Eigen::VectorXd vertex_area = vertex_areas(surface);
  m_diagonal = m_areas;
  std::vector<Eigen::Triplet<double>> shares;
  for (int i = 0; i < surface.size_of_sheets(); ++i) {
    const Sheet sheet = surface.sheet(i);
    for (const int v : sheet.corners) {
      const double share = sheet.share * sheet.area / 3 / vertex_area[v];
      shares.emplace_back(v, sheet.face, std::sqrt(factor) * share);
      m_diagonal[sheet.face] += factor * share;
    }
  }
  m_shares.resize(surface.size_of_vertices(), surface.size_of_faces());
  m_shares.setFromTriplets(shares.begin(), shares.end());
  m_solved_diagonal = m_diagonal;
}

Eigen::MatrixXd Potential_metric::apply(const Eigen::MatrixXd& d) const
{
  if (m_diagonal.size() > 0)
    return m_diagonal.asDiagonal() * d - m_shares.transpose() * (m_shares * d).eval();
  Eigen::MatrixXd y(d.rows(), d.cols());
  for (Eigen::Index k = 0; k < d.cols(); ++k) m_matrix.multiply(d.col(k), y.col(k));
  return y;
}

Eigen::MatrixXd Potential_metric::solve(const Eigen::MatrixXd& b) const
{
  Block<double> x;
  if (m_diagonal.size() == 0) {
    check(m_solver.solve(b, x));
    return x;
  }
  const Eigen::VectorXd inverse = m_solved_diagonal.cwiseInverse();
  const Eigen::MatrixXd part = inverse.asDiagonal() * b;
  check(m_solver.solve(m_shares * part, x));
  return part + inverse.asDiagonal() * (m_shares.transpose() * x).eval();
}

void Potential_metric::check(Solver_status status)
{
  if (status != Solver_status::success) throw Solver_error("Potential_metric", to_string(status));
}

}  // namespace Conformal_geometry_processing::internal
