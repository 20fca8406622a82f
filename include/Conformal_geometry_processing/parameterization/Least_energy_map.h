// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/subspace_iteration.h>
#include <Conformal_geometry_processing/parameterization/Parameterization_report.h>
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>

#include <complex>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

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
                             const Subspace_options& options,
                             Parameterization_report& report) const;

  /// Factors energy + shift weights, because the energy vanishes for constants. Constants then have
  /// the energy `constant`, far below that of all maps except those of flat surfaces; it must
  /// exceed the rounding errors of the zero eigenvalue, which are large for meshes with slivers.
  template <class Scalar>
  double factorize(const Hermitian_sparse_matrix<Scalar>& energy, const Eigen::VectorXd& weights,
                   Solver_ref<Scalar>& solver) const;

  void check(const char* step, Solver_status status) const;

  const Mesh_view& m_mesh;
  Eigen::MatrixXcd m_start;   // |V| x up to 4
  Eigen::VectorXd m_weights;  // |V|: 1 on the loops
  Map_solvers m_solvers;
  std::string m_function;
};

}  // namespace Conformal_geometry_processing::internal
