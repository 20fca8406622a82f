// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/exactness_functions.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>

#include <Eigen/Core>

#include <cmath>
#include <optional>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief Computes an orthonormal basis of the span of some functions, in the inner product
/// sum_i w_i a_i b_i, and omits nearly dependent directions.
///
/// Directions whose singular value is below `threshold` times the largest one are dropped: if
/// functions are dependent up to rounding or discretization errors, their differences are noise,
/// which a plain Gram-Schmidt process would normalize. The functions should have similar norms. The
/// basis is empty if there are no functions or all of them vanish.
///
/// Uses the eigenvectors of the Gram matrix, followed by a Cholesky decomposition that makes the
/// basis orthonormal up to rounding. Deterministic. About 8 n k^2 operations, in the memory of the
/// functions where they are moved into the call.
///
/// \param functions n x k, one per column
/// \param weights n positive numbers
/// \param threshold at least 1e-7: smaller singular values are lost in the Gram matrix
/// \returns n x r, r <= k, in the order of decreasing singular values
/// \throw Precondition_error if the sizes differ, a weight is not positive or a value not finite
Eigen::MatrixXd weighted_orthonormalization(Eigen::MatrixXd functions,
                                            const Eigen::VectorXd& weights,
                                            double threshold = 1e-3);

/// \ingroup PkgSpin
/// \brief Returns the component of v orthogonal to the span of a basis that is orthonormal with
/// respect to the weights.
///
/// Projects twice, so that the result is orthogonal even if v is almost inside the span and the
/// result consists of rounding errors. 8 n k operations.
/// \pre `basis` was returned by `weighted_orthonormalization()` for these weights
Eigen::VectorXd project_out(const Eigen::MatrixXd& basis, const Eigen::VectorXd& weights,
                            Eigen::VectorXd v);

namespace internal {

/// \brief an orthonormal basis of the functions on the vertices that a direction must be orthogonal
/// to, with the inner product sum_i M_V,i a_i b_i [CGP 6.4.4].
///
/// Functions are added in groups, such as the constants, the components of the normals, or the
/// functions that keep a torus closed. Each group is orthonormalised separately before it is added,
/// so the groups may differ in scale. Functions that depend linearly on earlier groups are dropped.
class Constraint_basis {
 public:
  /// \param areas M_V, |V| positive numbers
  explicit Constraint_basis(Eigen::VectorXd areas);

  /// \param functions |V| x k, one per column
  /// \throw Precondition_error if the number of rows is not |V|, or a value is not finite
  void add(Eigen::MatrixXd functions);

  /// the number of independent constraints
  Eigen::Index rank() const { return m_basis.cols(); }

  /// v without its component in the span of the constraints
  Eigen::VectorXd project_out(Eigen::VectorXd v) const;

  /// the norm sqrt(sum_i M_V,i v_i^2)
  double norm(const Eigen::VectorXd& v) const { return std::sqrt(m_areas.dot(v.cwiseAbs2())); }

 private:
  Eigen::VectorXd m_areas;  // |V|
  Eigen::MatrixXd m_basis;  // |V| x rank
};

/// \brief the functions that rho must be orthogonal to on a surface with handles or holes so that
/// the edges of the transformed surface stay exact, that is close up around them, and the defect of
/// a transformation [CGP 4.5.2].
struct Exactness_constraints {
  Curvature_potential::On on = Curvature_potential::On::vertices;  ///< where the values of rho are
  std::optional<Harmonic_part> forms;  ///< of the surface; none on spheres and disks
  Eigen::VectorXd weights;             ///< `cotan_weights()`, |E|
  Eigen::VectorXd areas;               ///< `curvature_areas()`, |V| or |F|
  Eigen::MatrixXd functions;  ///< `exactness_functions()`, three for each form; |V| or |F| rows
  bool constants_have_effect = false;  ///< gamma is a misfit, not an eigenvalue up to which rho is
                                       ///< realised
  int factorizations = 0;              ///< of X, and
  int solves = 0;                      ///< with its factor, that were needed

  /// the basis of the functions and, if constants have no effect, of the constants
  Constraint_basis basis() const;

  /// \brief the norm of the harmonic part of new edge vectors, relative to their norm: zero if they
  /// close up around the handles; always zero on spheres and disks.
  /// \param edges |E| x 3, of a transformation of the surface
  double period_defect(const Eigen::MatrixX3d& edges) const;
};

/// \brief the largest period defect of a transformation that counts as closed.
///
/// A defect shears the surface by about as much. By default it may be a quarter of the distortion
/// that the step has anyway, mean Q - 1: that is the discretisation error, O(h) and in proportion
/// to rho, so that the defect neither stops the convergence under refinement nor costs steps that
/// no one would notice. Never more than 2 % of the edges, because on bad meshes Q is large, nor
/// less than .2 %, which shears by less than one sees: maps in the plane have hardly any
/// distortion.
struct Period_limit {
  std::optional<double> maximum;  ///< relative to the edges; see above
  double tolerance = 0;           ///< of the spins: smaller defects are errors of the solver

  /// \param report of the transformation
  double operator()(const Spin_report& report) const;
};

}  // namespace internal

/// \ingroup PkgSpin
/// \brief computes the constraints of a surface.
///
/// Costs 4G solves with a Laplacian that is already factored, half as many from a start, a
/// factorization of the Dirac matrix for rho = 0, and about 4G solves with it; nothing without
/// generators.
///
/// \param system of the surface; its factor is overwritten
/// \param laplacian solves with the Laplacian of the surface
/// \param generators closed forms of the surface, one column for each loop around handles and holes
/// \param on where the values of rho are
/// \param version empty: no functions are computed. With a boundary, always the adjoint
/// \param start see `Hodge_decomposition`
/// \throw Solver_error if a factorization fails, or a solve
internal::Exactness_constraints exactness_constraints(internal::Dirac_system& system,
                                                      const internal::Grounded_solver& laplacian,
                                                      Eigen::MatrixXd generators,
                                                      Curvature_potential::On on,
                                                      std::optional<Exactness> version,
                                                      const internal::Harmonic_part* start = {});

}  // namespace Conformal_geometry_processing
