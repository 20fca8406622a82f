// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "factors.h"

/// The table of the roofline: the bytes that a stage reads and writes at least, from and to memory,
/// and the time in which it does, against the bandwidth of the machine on one thread.
namespace cgp_benchmark {

using Quaternion = CGP::Quaternion<double>;

/// the triad of STREAM (McCalpin 1995), a = b + 3 c, on arrays that no cache holds
class Triad {
 public:
  void run()
  {
    for (std::size_t i = 0; i < m_a.size(); ++i) m_a[i] = m_b[i] + 3 * m_c[i];
    std::swap(m_a, m_b);  // so that no run is in vain
  }

  double bytes() const { return 3. * sizeof(double) * static_cast<double>(m_a.size()); }

 private:
  static constexpr std::size_t size = std::size_t(1) << 24;
  std::vector<double> m_a = std::vector<double>(size, 1), m_b = m_a, m_c = m_a;
};

template <class Stage>
static void measure_stage(const Job& job, double bytes, const Stage& stage, Record& record)
{
  Triad triad;
  double seconds = never, of_triad = never;
  repeat(job, [&] {
    keep_least(of_triad, [&] { triad.run(); });
    for (int i = 0; i < 3; ++i) keep_least(seconds, stage);
  });
  record.add("bytes", bytes).add("seconds", seconds).add("bandwidth", triad.bytes() / of_triad);
}

/// the factor is read twice, right-hand sides are read and solutions written
template <class Scalar, bool is_rounded>
static void measure_solution(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  const auto A = matrix_of<Scalar>(job, mesh);
  const Eigen::VectorXd shift = 1e-3 * CGP::vertex_areas(mesh);
  const auto b = right_hand_sides<Scalar>(A.size());
  CGP::Block<Scalar> x = b;
  CGP::Supernodal_cholesky<Scalar> solver;
  require(solver.analyze_with_positions(A.pattern(), mesh.positions()));
  require(is_rounded ? solver.factorize_preconditioner(A, shift) : solver.factorize(A, shift));
  const double entry = is_rounded ? sizeof(Scalar) / 4. : sizeof(Scalar);
  const double bytes = 2 * entry * static_cast<double>(solver.statistics().factor_entries) +
                       2. * sizeof(Scalar) * static_cast<double>(b.size());
  measure_stage(
      job, bytes, [&] { require(solver.precondition(b, x)); }, record);
}

/// each entry of the matrix once, with its row
static double bytes_of(const CGP::Sparse_pattern& pattern)
{
  return double(pattern.size_of_entries()) * (sizeof(Quaternion) + sizeof(int));
}

/// a vector is read, another one written
static void measure_product(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  const auto X = matrix_of<Quaternion>(job, mesh);
  const CGP::Quaternion_vector<double> x = right_hand_sides<Quaternion>(X.size()).col(0);
  CGP::Quaternion_vector<double> y;
  const double bytes = bytes_of(X.pattern()) + 2. * sizeof(Quaternion) * X.size();
  measure_stage(
      job, bytes, [&] { y = X * x; }, record);
}

/// of a face corners, edges, area and rho, and positions; the matrix is written
static void measure_assembly(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  const CGP::Curvature_potential rho = smooth_potential(mesh, job.amplitude);
  CGP::Hermitian_sparse_matrix<Quaternion> X(CGP::vertex_graph(mesh));
  const double bytes = bytes_of(X.pattern()) + 24. * mesh.size_of_vertices() +
                       (6 * sizeof(int) + 2 * sizeof(double)) * double(mesh.size_of_faces());
  measure_stage(
      job, bytes, [&] { CGP::assemble_dirac_energy(mesh, rho, X); }, record);
}

void add_roofline(std::vector<Row>& rows)
{
  rows.push_back({"roofline", "solution with X, rounded", measure_solution<Quaternion, true>});
  rows.push_back({"roofline", "solution with X, double", measure_solution<Quaternion, false>});
  rows.push_back({"roofline", "solution with L, three columns", measure_solution<double, false>});
  rows.push_back({"roofline", "product with X", measure_product});
  rows.push_back({"roofline", "assembly of X", measure_assembly});
}

}  // namespace cgp_benchmark
