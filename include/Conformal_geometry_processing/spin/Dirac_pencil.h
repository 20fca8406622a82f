// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_PENCIL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_PENCIL_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Krylov_space.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Reduced_hermitian_solver.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Prescribed_directions.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the Hermitian forms of D - rho on the spins of a surface, and the inverse of its energy:
/// X = A^H M_F A, the Hermitian part of B^H M_F A, and M_V, with A = D - R.
///
/// With a condition at the boundary all of them are restricted to the spins that fulfil it. Where
/// rho = 0 the constants in the space are in the kernel of the first two; they are left out then.
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class SolverTraits>
class Dirac_pencil {
 public:
  using Vectors = Block<Quaternion<double>>;

  /// \param mesh must outlive the object
  /// \param condition of directions, or none on a closed surface
  /// \pre `require_surface(mesh)` and `require_condition(mesh, condition)` hold
  /// \throw Solver_error if the analysis fails
  Dirac_pencil(const Mesh_view& mesh, const Boundary_condition& condition,
               const std::string& function);

  Dirac_pencil(const Dirac_pencil&) = delete;
  Dirac_pencil& operator=(const Dirac_pencil&) = delete;

  /// \brief assembles and factors X.
  /// \throw Solver_error if that fails
  void set_potential(Curvature_potential rho);

  /// the spins in the kernel of A that are left out, orthonormal with M_V
  const Vectors& constants() const { return m_constants; }

  /// over which numbers the spins are a space
  Coefficients coefficients() const;

  /// K = B^H M_F A, N = X with a diagonal shift that keeps it definite; refers to the object
  Pencil of_form() const;

  /// K = M_V, and N as before
  Pencil of_masses() const;

  /// X^-1 of noise
  Vectors noise(Eigen::Index columns, unsigned seed) const;

  /// <v, X v>
  double energy(const Quaternion_vector<double>& v) const { return inner_product(v, m_X * v).w; }

  /// <v, M_V v>
  double squared_norm(const Quaternion_vector<double>& v) const;

  /// A^H M_V B
  Vectors products(const Vectors& a, const Vectors& b) const;

  /// over the numbers of `coefficients()`
  Dirac_forms forms(const Vectors& v) const;

  /// the mean of |lambda|^2 becomes one; over the quaternions see `fix_gauge()`
  Quaternion_vector<double> normalized(Quaternion_vector<double> lambda) const;

 private:
  void check(const char* step, Solver_status status) const;

  /// 4 pi / area: the size of the low eigenvalues of X
  double unit() const;

  const Reduced_basis<double>& basis() const { return m_directions->basis(); }

  Vectors projected(Vectors v) const { return m_directions ? basis().project(std::move(v)) : v; }

  /// the kernel of D in the space, orthonormal with M_V
  Vectors find_constants() const;

  /// X with a shift of its diagonal that makes it definite, where the constants are in its kernel
  void factorize();
  Vectors apply_form(const Vectors& v) const;
  Vectors apply_energy(const Vectors& v) const;
  Vectors solve(Vectors b) const;

  std::string m_function;
  const Mesh_view& m_mesh;
  Eigen::VectorXd m_areas;
  Hermitian_sparse_matrix<Quaternion<double>> m_X;
  typename SolverTraits::template Solver<Quaternion<double>> m_solver;
  std::unique_ptr<Prescribed_directions<SolverTraits>> m_directions;
  Reduced_hermitian_solver m_reduced;
  Curvature_potential m_rho = no_potential(m_mesh);
  Vectors m_constants;
  double m_regularization = 0;  // of the diagonal, in M_V
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Dirac_pencil_templates.h>
#endif

#endif
