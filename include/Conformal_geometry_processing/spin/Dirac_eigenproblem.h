// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_EIGENPROBLEM_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_EIGENPROBLEM_H

#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/direct/release_factor.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the eigenvalue problem X lambda = mu M_V lambda of one mesh, for any number of rho
/// [CGP (5.3)].
///
/// The pattern, the ordering of the vertices and the symbolic factorization are made once;
/// `set_potential()` repeats the numbers only, for another rho or other positions.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
/// \tparam Surface `Mesh_view`, or `Delaunay_view` for the robust operators
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits, class Surface = Mesh_view>
class Dirac_eigenproblem {
 public:
  using Vectors = Block<Quaternion<double>>;
  using Matrix = Hermitian_sparse_matrix<Quaternion<double>>;
  using Solver = typename SolverTraits::template Solver<Quaternion<double>>;

  /// \param mesh must outlive the object
  /// \pre `require_surface(mesh)` holds
  /// \throw Solver_error if the analysis fails
  explicit Dirac_eigenproblem(const Surface& mesh);

  /// the mesh has new positions; the next call must be `set_potential()`
  void update_geometry() { m_areas = vertex_areas(m_mesh); }

  const Surface& mesh() const { return m_mesh; }
  const Eigen::VectorXd& areas() const { return m_areas; }
  const Matrix& matrix() const { return m_X; }
  const Solver& solver() const { return m_solver; }

  /// 4 pi / area: the size of the low eigenvalues
  double unit() const;

  /// \brief assembles X for rho and factors it, shifted by a thousandth of `unit()`, or by a
  /// hundredth where rounding makes that indefinite (slivers, factors in single precision).
  ///
  /// X is singular for rho = 0 and nearly so for small rho. A smaller shift would let the rounding
  /// of the solves blow up along the wanted vector; Rayleigh-Ritz takes the effect of this one out.
  /// \throw Solver_error if X is not positive definite to rounding, or memory is short
  void set_potential(const Curvature_potential& rho, Dirac_solution::Seconds& seconds);

  /// \brief assembles X for rho and factors it with a given shift of its diagonal, |V|
  /// \throw Solver_error as above
  void set_potential(const Curvature_potential& rho, const Eigen::VectorXd& shift,
                     Dirac_solution::Seconds& seconds);

  /// assembles X for rho, and factors nothing
  void assemble(const Curvature_potential& rho, Dirac_solution::Seconds& seconds);

  /// \brief x with (X + shift) x = b
  /// \pre `set_potential()` has been called
  Vectors solve(const Vectors& b) const;

  /// \brief the smallest eigenpairs, as many as `start` has columns; `wanted` of them converge.
  /// \pre `set_potential()` has been called
  Eigensolver_result smallest(Vectors start, int wanted, double tolerance, int max_iterations,
                              const Go_further& go_further) const;

  /// \brief two start vectors: `guide`, and X^-1 applied to noise.
  /// \pre `set_potential()` has been called
  Vectors start(const Quaternion_vector<double>& guide, unsigned seed) const;

  /// [v, r], |V| x 2, where r is what remains of `guide` without v
  Vectors with_rest(const Quaternion_vector<double>& v,
                    const Quaternion_vector<double>& guide) const;

  /// \brief what the inverse of D - rho makes of v, beyond a multiple of v; |V| x 1.
  ///
  /// X^-1 times the signed form is that inverse on smooth vectors. Where v is no eigenvector of
  /// D - rho but a mixture of two, the companion has the other mixture of them in it, besides the
  /// discretisation error; otherwise it is only that error, or zero.
  /// \pre `set_potential()` has been called
  /// \param image `apply_dirac_form()` of v
  Vectors companion(const Quaternion_vector<double>& v,
                    const Quaternion_vector<double>& image) const;

  /// \brief one more column for the companions of v: X^-1 M_V of the last, beyond a multiple of v.
  /// The vector of smallest energy in their span is then nearer to an eigenvector.
  void add_companion(const Quaternion_vector<double>& v, Vectors& companions) const;

  /// \brief [v, w], |V| x 2, where w is the vector of smallest energy in the span of `companions`;
  /// v alone if they are zero
  Vectors with_lowest(const Quaternion_vector<double>& v, Vectors companions) const;

  /// gives back the memory of the factor, for the stages that come after
  void release() { release_factor(m_solver); }

  /// |<a, b>| / (|a| |b|) in [0, 1]: one if the vectors differ by a right factor only
  double overlap(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b) const;

  /// <a, M_V a>
  double squared_norm(const Quaternion_vector<double>& a) const;

 private:
  static void check(const char* step, Solver_status status);
  Vectors inverse_beyond(const Quaternion_vector<double>& v,
                         const Quaternion_vector<double>& b) const;
  Vectors without(const Quaternion_vector<double>& v, const Quaternion_vector<double>& u) const;

  const Surface& m_mesh;
  Eigen::VectorXd m_areas;  // |V|
  Matrix m_X;
  Solver m_solver;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem_templates.h>
#endif

#endif
