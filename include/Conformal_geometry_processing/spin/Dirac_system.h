// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Prescribed_boundary.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>

namespace Conformal_geometry_processing::internal {

/// \brief the discrete operator D - rho of a surface in least-squares form, X = (D - R)^H M (D -
/// R), on a space of spins, with the factor of X [CGP (5.3), Alg. 2].
///
/// The space is H^n by default; with directions prescribed at the boundary, the real vector space
/// of spins that turn the boundary directions into them; with prescribed positions, the spins with
/// given boundary values. The pattern, the ordering of the vertices and the symbolic factorization
/// are computed once; `set_potential()` repeats only the numeric part, for another rho or other
/// vertex positions.
///
/// `solve_dirac_equation()` and `Dirac_spectral_problem` solve equations with it.
///
class Dirac_system {
 public:
  using Vectors = Block<Quaternion<double>>;
  using Matrix = Hermitian_sparse_matrix<Quaternion<double>>;
  using Solver = Solver_ref<Quaternion<double>>;
  using Directions = Prescribed_directions;
  using Positions = Prescribed_positions;

  /// what a factor is for: `precondition()` alone takes a less exact one
  enum class Use { solution, preconditioner };

  /// \param surface must outlive the object
  /// \param function named in exceptions
  /// \pre `require_surface()` of the mesh holds
  /// \throw Precondition_error if the condition does not fit the surface, see
  /// `require_condition()`, or if prescribed positions require another spin structure
  /// \throw Solver_error if the analysis fails
  /// \param part which of the surface is meant, whose solvers solve systems of the whole; without
  /// prescribed directions or positions
  explicit Dirac_system(const Surface_ref& surface, const Boundary_condition& condition = {},
                        const std::string& function = "Dirac_system",
                        const Spin_solvers& solvers = {}, const Surface_part& part = {});

  Dirac_system(const Dirac_system&) = delete;
  Dirac_system& operator=(const Dirac_system&) = delete;

  /// \brief adopts new positions of the surface; `set_potential()` must be called next.
  /// \pre no positions are prescribed
  void update_geometry();

  const Surface_ref& surface() const { return m_surface; }
  const Surface_part& part() const { return m_part; }
  const Eigen::VectorXd& areas() const { return m_areas; }  ///< M_V, |V|
  double area() const { return m_area; }                    ///< their sum

  /// over the area, of values at vertices
  double mean(const Eigen::VectorXd& values) const
  {
    return m_part.sum(m_areas.dot(values)) / m_area;
  }

  /// of all parts
  Quaternion<double> sum(const Quaternion<double>& own) const
  {
    const Eigen::VectorXd all = m_part.sum(Eigen::Vector4d(own.w, own.x, own.y, own.z));
    return {all[0], all[1], all[2], all[3]};
  }

  const Matrix& matrix() const { return m_X; }
  bool is_closed() const { return m_is_closed; }

  /// whether gamma is a true eigenvalue, up to which rho is realised; otherwise it is a misfit
  bool is_self_adjoint() const { return m_is_closed || m_is_self_adjoint; }

  const Directions* directions() const { return m_directions.get(); }  ///< prescribed, or null
  Positions* positions() { return m_positions.get(); }                 ///< prescribed, or null
  const Positions* positions() const { return m_positions.get(); }

  /// the scalars of the space of spins
  Coefficients coefficients() const;

  /// 4 pi / area: the order of magnitude of the low eigenvalues of X
  double unit() const;

  /// assembles X for rho without factoring it, unless it is that of rho already
  void assemble(const Curvature_potential& rho, Dirac_evidence::Seconds& seconds);

  /// \brief assembles X for rho and factors it, shifted by a multiple of `unit()` M_V.
  ///
  /// X is singular for rho = 0 and nearly singular for small rho. The multiples tried are `least`
  /// and then 1e-6, 1e-3 and 1e-2, until X is positive definite despite rounding: slivers
  /// need larger ones. For eigenvectors `least` should be 1e-3: with a smaller shift, the solves
  /// amplify rounding errors along the wanted vector, whereas Rayleigh-Ritz removes the effect of
  /// this shift. A multiple below 0 approximates (X - mu M_V)^-1, where mu is known to be about the
  /// smallest eigenvalue; if the solver finds the matrix not positive definite then, 1e-3 is tried.
  /// \throw Solver_error if X is not positive definite up to rounding, or memory is short
  void set_potential(const Curvature_potential& rho, Dirac_evidence::Seconds& seconds,
                     Use use = Use::solution, double least = 1e-3);

  /// \brief the same with a given shift of the diagonal, |V|.
  /// \throw Solver_error as above
  void set_potential(const Curvature_potential& rho, const Eigen::VectorXd& shift,
                     Dirac_evidence::Seconds& seconds);

  /// the shift of the last `set_potential()` with a share, as a multiple of M_V
  double shift() const { return m_shift; }

  /// \brief solves (X + shift) x = b in the space.
  /// \pre `set_potential()` was called last, for solutions
  Vectors solve(const Vectors& b) const;

  /// \brief the same as accurately as a preconditioner.
  /// \pre `set_potential()` was called last, for whatever use
  Vectors precondition(const Vectors& b) const;

  /// \brief factors X for rho = 0, for `response()`.
  ///
  /// With a free boundary, X is shifted by `nearness_weight()`: infinitely many spins solve the
  /// equation, and those nearest to 1 are wanted.
  void prepare_response();

  /// \brief the response y of lambda = 1 to sources c: solves D^H M D y = c in the space. On closed
  /// surfaces, where the kernel consists of the constants, y has mean zero and the mean of c is
  /// ignored.
  /// \param tolerance of the relative error in the energy norm, on closed surfaces
  /// \param solves increased by the number of solves with the factor
  /// \pre `prepare_response()` was called last
  /// \throw Solver_error if the solver fails
  Vectors response(const Vectors& c, double tolerance, int& solves) const;
  Vectors response(const Vectors& c) const
  {
    int solves = 0;
    return response(c, 1e-11, solves);
  }

  /// X^-1 applied to random vectors: start vectors of an iteration
  Vectors noise(Eigen::Index columns, unsigned seed) const;

  /// the nearest vectors in the space
  Vectors projected(Vectors v) const;

  const Spin_solvers& solvers() const { return m_solvers; }

  /// the solver on all of H^n; its analysis is shared
  const Solver& solver() const { return m_solver; }

  /// the solver on the space of prescribed directions
  /// \pre directions are prescribed
  const Reduced_hermitian_solver& reduced_solver() const { return *m_reduced; }

  /// releases the memory of the factors until the next `set_potential()`
  void release();

  /// how often the matrix, the factor or the geometry have changed: as long as this is the same,
  /// they are
  int changes() const { return m_changes; }

  /// <a, M_V a>
  double squared_norm(const Quaternion_vector<double>& a) const;

  /// |<a, b>| / (|a| |b|) in [0, 1] over the numbers of `coefficients()`: one if the vectors differ
  /// by a right factor only
  double overlap(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b) const;

  /// `overlap()` with lambda = 1 over the quaternions
  double overlap_with_identity(const Quaternion_vector<double>& a) const;

  /// scales lambda so that the mean of |lambda|^2 is one; over the quaternions see `fix_gauge()`
  Quaternion_vector<double> normalized(Quaternion_vector<double> lambda) const;

 private:
  void check(const char* step, Solver_status status) const;
  Solver_status factorize(const Eigen::VectorXd& shift, Use use);

  void find_areas();

  std::string m_function;
  Surface_ref m_surface;
  Surface_part m_part;
  bool m_is_closed, m_is_self_adjoint;
  Eigen::VectorXd m_areas;  // |V|
  double m_area = 0;
  Matrix m_X;
  std::optional<Curvature_potential> m_rho;  // of m_X
  Spin_solvers m_solvers;
  Solver m_solver;
  std::optional<Reduced_hermitian_solver> m_reduced;  // where directions are prescribed
  std::unique_ptr<Directions> m_directions;
  std::unique_ptr<Positions> m_positions;
  double m_shift = 0;
  int m_changes = 0;
};

/// \brief solves X y = c on a connected closed surface, where the kernel of X = D^H M D consists of
/// the constants: y has mean zero, and the mean of c, which is not in the range of X, is removed.
///
/// Uses conjugate gradients on X itself, preconditioned by any available factor: that of X plus a
/// small multiple of M_V needs about five iterations; factors of nearby matrices work as well.
/// \param areas M_V \param solver with such a factor
/// \param tolerance of the relative error in the energy norm
/// \param solves increased by the number of solves with the factor
/// \throw Solver_error if the solver fails, or the iterations do not converge
Block<Quaternion<double>> closed_response(const Hermitian_sparse_matrix<Quaternion<double>>& X,
                                          const Eigen::VectorXd& areas,
                                          const Solver_ref<Quaternion<double>>& solver,
                                          Block<Quaternion<double>> c, double tolerance,
                                          int& solves);

}  // namespace Conformal_geometry_processing::internal
