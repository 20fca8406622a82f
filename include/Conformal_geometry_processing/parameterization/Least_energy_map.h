// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_LEAST_ENERGY_MAP_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_LEAST_ENERGY_MAP_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/subspace_iteration.h>
#include <Conformal_geometry_processing/parameterization/Parameterization_report.h>
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>

#include <complex>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgParameterization
/// \brief Finds the map z = a + i b to the plane that minimizes an energy under the constraint that
/// the sum of |z - mean|^2 over the vertices of some loops is one.
///
/// Energies that are invariant under rotations of the image are complex matrices, |V| x |V|; other
/// energies are real matrices, 2|V| x 2|V|, in the order a_0, b_0, a_1, b_1, ...
class Least_energy_map {
  using Complex = std::complex<double>;

 public:
  /// \param loops the constrained ones; the first one has at least three edges
  Least_energy_map(const Mesh_view& mesh, const std::vector<Vertex_loop>& loops,
                   const Map_solvers& solvers, std::string function);

  /// \param report receives the results of the eigensolver, and the seconds
  /// \throw Solver_error if a factorization fails
  Eigen::VectorXcd find(const Hermitian_sparse_matrix<Complex>& energy,
                        const Subspace_options& options, Parameterization_report& report) const;
  Eigen::VectorXcd find(const Hermitian_sparse_matrix<double>& energy,
                        const Subspace_options& options, Parameterization_report& report) const;

 private:
  /// Reorders rows 0 ... n-1, n ... 2n-1 to 0, n, 1, n+1, ...
  static Eigen::MatrixXd interleaved(const Eigen::MatrixXd& x);

  template <class Scalar>
  Vector<Scalar> eigenvector(const Hermitian_sparse_matrix<Scalar>& energy,
                             Solver_ref<Scalar>& solver, const Centered_mass<Scalar>& mass,
                             const Eigen::VectorXd& weights, const Block<Scalar>& start,
                             const Subspace_options& options, Parameterization_report& report) const
  {
    Stopwatch watch;
    const double shift = factorize(energy, weights, solver);
    report.seconds.factorization = watch.lap();
    Subspace_result<Scalar> result =
        subspace_iteration(energy, mass, shift, solver, start, options);
    check("solution", result.status);
    report.seconds.eigenvector = watch.lap();
    report.converged = result.converged;
    report.eigenvalue = result.eigenvalue;
    report.next_eigenvalue = result.next_eigenvalue;
    report.residual = result.residual;
    report.iterations = result.iterations;
    report.normalized_vertices = static_cast<int>(m_weights.sum());
    return std::move(result.vector);
  }

  /// Factors energy + shift weights, because the energy vanishes for constants. Constants then have
  /// the energy `constant`, far below that of all maps except those of flat surfaces; it must
  /// exceed the rounding errors of the zero eigenvalue, which are large for meshes with slivers.
  template <class Scalar>
  double factorize(const Hermitian_sparse_matrix<Scalar>& energy, const Eigen::VectorXd& weights,
                   Solver_ref<Scalar>& solver) const
  {
    Solver_status status = Solver_status::success;
    for (const double constant : {1e-8, 1e-6, 1e-4}) {
      const double shift = constant / m_weights.sum();
      status = solver.factorize(energy, shift * weights);
      if (status == Solver_status::success) return shift;
      if (status != Solver_status::not_positive_definite) break;
    }
    check("factorization", status);
    return 0;
  }

  void check(const char* step, Solver_status status) const;

  const Mesh_view& m_mesh;
  Eigen::MatrixXcd m_start;   // |V| x up to 4
  Eigen::VectorXd m_weights;  // |V|: 1 on the loops
  Map_solvers m_solvers;
  std::string m_function;
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/parameterization/Least_energy_map_impl.h>
#endif

#endif
