// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Outline_fairing.h>

#include <Conformal_geometry_processing/conformal_class/Class_equations.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

constexpr double least_share_of_relaxation = .125;

/// the vertices that stay
inline std::vector<int> held_vertices(const Fairing_patch& patch)
{
  std::vector<int> held;
  for (int v = 0; v < patch.mesh().size_of_vertices(); ++v)
    if (!patch.is_free(v)) held.push_back(v);
  return held;
}

}  // namespace internal

internal::Outline_fairing::Outline_fairing(const Fairing_patch& patch)
    : m_patch(patch),
      m_bending(patch),
      m_start(patch.mesh().positions()),
      m_matrix(m_bending.pattern()),
      m_laplacian(vertex_graph(patch.mesh())),
      m_harmonic(m_laplacian.shared_pattern(), held_vertices(patch))
{
  require_fairing_solver(m_solver.analyze(m_matrix.pattern()));
  offer(patch.mesh().positions());
  offer(harmonic_with_unit_weights());
  const Mesh_view first(m_start, patch.mesh().corners());
  assemble_cotan_laplacian(first, cotan_weights(first), m_laplacian);
  m_harmonic.factorize(m_laplacian);
}

// A surface too degenerate for a factor is not a start.
void internal::Outline_fairing::offer(const Points& f)
{
  try {
    Points g = f;
    for (int k = 0; k < 2; ++k) g = biharmonic(Bending_energy(m_patch, g));
    if (Bending_energy(m_patch, g).value() < Bending_energy(m_patch, m_start).value())
      m_start = std::move(g);
  } catch (const Solver_error& error) {
    if (is_out_of_memory(error)) throw;
  }
}

Points internal::Outline_fairing::harmonic_with_unit_weights() const
{
  const Mesh_view& mesh = m_patch.mesh();
  Hermitian_sparse_matrix<double> L(m_laplacian.shared_pattern());
  assemble_cotan_laplacian(mesh, Eigen::VectorXd::Ones(mesh.size_of_edges()), L);
  Dirichlet_solver<double> solver(m_laplacian.shared_pattern(), held_vertices(m_patch));
  solver.factorize(L);
  const Block<double> f = mesh.positions().transpose();
  return solver.solve(L, Block<double>::Zero(f.rows(), 3), f).transpose();
}

void internal::Outline_fairing::assemble(const Bending_energy& energy)
{
  m_matrix.set_zero();
  m_bending.assemble(energy, [this](int k, double x) { m_matrix.value(k) += x; });
}

// K f = 0 with all vertices, of which the held ones are the right-hand side: L A^-1 L of f without
// the free ones.
Points internal::Outline_fairing::biharmonic(const Bending_energy& energy)
{
  assemble(energy);
  require_fairing_solver(m_solver.factorize(m_matrix, {}));
  const Mesh_view& mesh = energy.mesh();
  Points f = mesh.positions();
  for (int k = 0; k < m_patch.size(); ++k) f.col(m_patch.free_vertex(k)).setZero();
  Hermitian_sparse_matrix<double> L(m_laplacian.shared_pattern());
  assemble_cotan_laplacian(mesh, energy.weights(), L);
  const auto laplacian = block_operator(L);
  Block<double> curvature = laplacian(f.transpose());
  for (int v = 0; v < f.cols(); ++v)
    curvature.row(v) *= m_patch.bends(v) ? -.5 / energy.areas()[v] : 0;
  const Block<double> force = laplacian(curvature);
  Block<double> b(m_patch.size(), 3), x;
  for (int k = 0; k < m_patch.size(); ++k) b.row(k) = force.row(m_patch.free_vertex(k));
  require_fairing_solver(m_solver.solve(b, x));
  return moved(m_patch, std::move(f), x.transpose());
}

Points internal::Outline_fairing::relaxation(const Bending_energy& energy) const
{
  const Points N = vertex_normals(energy.mesh());
  const Points& f = energy.mesh().positions();
  const auto tangential = [&](int v, const Eigen::Vector3d& d) -> Eigen::Vector3d {
    return d - N.col(v).dot(d) * N.col(v);
  };
  Block<double> b(f.cols(), 3);
  for (int c = 0; c < 3; ++c) b.col(c) = -(m_laplacian * f.row(c).transpose());
  for (int v = 0; v < f.cols(); ++v) b.row(v) = tangential(v, b.row(v).transpose()).transpose();
  const Block<double> d = m_harmonic.solve(m_laplacian, b, Block<double>::Zero(f.cols(), 3));
  Points way(3, m_patch.size());
  for (int k = 0; k < m_patch.size(); ++k) {
    const int v = m_patch.free_vertex(k);
    way.col(k) = tangential(v, d.row(v).transpose());
  }
  return way;
}

Points internal::Outline_fairing::descent(const Bending_energy& energy) const
{
  const Points N = vertex_normals(energy.mesh()), g = energy.gradient();
  Block<double> b(m_patch.size(), 1), phi;
  for (int k = 0; k < m_patch.size(); ++k) {
    const int v = m_patch.free_vertex(k);
    b(k, 0) = -N.col(v).dot(g.col(v));
  }
  require_fairing_solver(m_solver.solve(b, phi));
  Points d(3, m_patch.size());
  for (int k = 0; k < m_patch.size(); ++k) d.col(k) = phi(k, 0) * N.col(m_patch.free_vertex(k));
  return d;
}

internal::Fairing_step internal::Outline_fairing::step(const Bending_energy& present)
{
  const Points way = relaxation(present);
  m_share = (std::min)(1., (std::max)(2 * m_share, least_share_of_relaxation));
  for (; m_share >= least_share_of_relaxation; m_share /= 2) {
    const Points relaxed = moved(m_patch, present.mesh().positions(), way, m_share);
    try {
      Fairing_step next = descend_from(relaxed, present, 2);
      if (next.is_lower) return next;
    } catch (const Solver_error& error) {
      if (is_out_of_memory(error)) throw;  // otherwise the relaxed surface is too degenerate
    }
  }
  m_share = 0;
  return descend_from(present.mesh().positions(), present, 12);
}

internal::Fairing_step internal::Outline_fairing::descend_from(const Points& relaxed,
                                                               const Bending_energy& present,
                                                               int halvings)
{
  const Bending_energy energy(m_patch, relaxed);
  assemble(energy);
  require_fairing_solver(factorize_definite(m_solver, m_matrix, 1));
  const Points d = descent(energy);
  Fairing_step next;
  for (double t = 1; halvings >= 0 && !next.is_lower; t /= 2, --halvings) {
    next.f = moved(m_patch, relaxed, d, t);
    next.is_lower = Bending_energy(m_patch, next.f).value() < present.value();
  }
  return next;
}

}  // namespace Conformal_geometry_processing
