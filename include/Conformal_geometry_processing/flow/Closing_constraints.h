// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_CONSTRAINTS_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_CONSTRAINTS_H

#include <Conformal_geometry_processing/flow/Constraint_basis.h>
#include <Conformal_geometry_processing/forms/Dirac_energy_solver.h>
#include <Conformal_geometry_processing/forms/Exactness_constraints.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Grounded_solver.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Surface_dirac_equation.h>

#include <Eigen/Core>

#include <cmath>
#include <optional>

namespace Conformal_geometry_processing {

namespace internal {

/// \brief What rho must be orthogonal to: functions, and the constants where they have no effect.
/// \param areas that belong to the values of rho
inline Constraint_basis closing_basis(const Eigen::VectorXd& areas, bool is_self_adjoint,
                                      const Eigen::MatrixXd& functions)
{
  Constraint_basis basis(areas);
  if (is_self_adjoint) basis.add(Eigen::VectorXd::Ones(functions.rows()));
  basis.add(functions);
  return basis;
}

/// The norm of the harmonic part of edge vectors by theirs. \param w cotan weights
inline double period_defect(const Eigen::VectorXd& w, const Harmonic_basis& basis,
                            const Eigen::MatrixX3d& edges)
{
  // |w|, for w itself is negative opposite large angles and then defines no norm.
  const double total = w.cwiseAbs().dot(edges.rowwise().squaredNorm());
  return basis.coefficients(w, edges).norm() / std::sqrt(total);
}

}  // namespace internal

/// \ingroup PkgFlow
/// \brief what a moving surface with handles or holes needs so that its edges keep fitting together
/// around them: harmonic forms, the functions that rho must be orthogonal to, and how far a
/// transformation was from closing up [CGP 4.5.2].
///
/// The loops around handles and holes are found once. For every new geometry `update()` costs 4G
/// solves with a Laplacian that is factored already, a factorization of the Dirac matrix, and 2G
/// systems with it. Spheres and disks have none, and cost nothing.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits>
class Closing_constraints {
 public:
  using Equation = Surface_dirac_equation<SolverTraits, EigensolverTraits>;

  /// \param mesh its positions may change; must outlive the object
  /// \param equation that of the mesh; must outlive the object
  /// \param version none if there shall be no functions
  /// \param on where the curvature lives that is to be constrained
  /// \pre `require_surface(mesh)` holds
  Closing_constraints(const Mesh_view& mesh, Equation& equation, std::optional<Exactness> version,
                      Curvature_potential::On on = Curvature_potential::On::vertices);

  /// \brief follows the mesh to its present positions.
  /// \param laplacian solves with the Laplacian of the mesh as it is now
  /// \throw Solver_error if a factorization fails, or a solve
  void update(const Grounded_solver<SolverTraits>& laplacian);

  /// the number of loops around handles and holes, 2G or 2G + number of holes - 1
  int size_of_loops() const { return static_cast<int>(m_generators.cols()); }

  /// \brief what rho must be orthogonal to: `functions()`, and the constants, which have no effect
  /// but where a boundary is free or has prescribed tangents.
  Constraint_basis basis() const;

  /// three for each loop; |V| or |F| rows
  const Eigen::MatrixXd& functions() const { return m_functions; }

  /// \brief the norm of the harmonic part of new edge vectors by their norm: zero where they close
  /// up around the handles; always zero for spheres and disks.
  /// \param edges |E| x 3, of a transformation of the mesh as it was in `update()`
  double defect(const Eigen::MatrixX3d& edges) const;

 private:
  Eigen::MatrixXd closed_functions();
  Eigen::MatrixXd bounded_functions();

  const Mesh_view& m_mesh;
  Equation& m_equation;
  std::optional<Exactness> m_version;
  Curvature_potential::On m_on;
  Eigen::MatrixXd m_generators;  // |E| x number of loops
  Harmonic_basis m_basis;
  std::optional<Dirac_energy_solver<SolverTraits>> m_inverse;
  Eigen::MatrixXd m_functions;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/flow/Closing_constraints_templates.h>
#endif

#endif
