// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_CONSTRAINED_DIRECTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_CONSTRAINED_DIRECTION_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/flow/Closing_constraints.h>
#include <Conformal_geometry_processing/flow/Constraint_basis.h>
#include <Conformal_geometry_processing/flow/Curvature_filter.h>
#include <Conformal_geometry_processing/flow/Flow_options.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Surface_dirac_equation.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief what becomes of the direction of a flow before it may move the surface: it is filtered,
/// and loses what the constraints forbid [CGP 6.4.4].
///
/// Forbidden are the constants, where they change nothing; the functions of `Closing_constraints`;
/// and on closed surfaces the components of the normals, which belong to sphere inversions:
/// curvature has no part along them, but its filtered part has, and would set the surface drifting.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
/// \tparam Direction a model of `CurvatureDirection`
template <class SolverTraits, class EigensolverTraits, class Direction>
class Constrained_direction {
 public:
  using Equation = Surface_dirac_equation<SolverTraits, EigensolverTraits>;

  /// of one surface
  struct Result {
    Eigen::VectorXd v;  ///< |V| numbers in 1/length
    double norm = 0;    ///< root of the integral of v^2
    double share = 0;   ///< what is left of the direction, between 0 and 1

    /// \brief whether a share of at most `tolerance` is left of the direction, or of the curvature
    /// of a round sphere: that of a flat surface is rounding, of which all is left.
    bool has_vanished(double tolerance) const;
  };

  /// \param mesh its positions may change; must outlive the object, and so must `equation`
  /// \param equation that of the mesh, whose analysis is shared
  Constrained_direction(const Mesh_view& mesh, Direction direction, const Flow_options& options,
                        Equation& equation, std::string function);

  const Direction& unconstrained() const { return m_direction; }

  /// \brief the direction of the mesh as it is now.
  /// \param laplacian solves with its Laplacian
  /// \throw Precondition_error if the direction is not one finite number per vertex
  /// \throw Solver_error if a factorization fails, or a solve, or the surface has degenerated so
  /// far that its constraints make no sense
  Result operator()(const Grounded_solver<SolverTraits>& laplacian);

  /// what a change of curvature may keep if the surface is to close
  Eigen::VectorXd closing_part(const Eigen::VectorXd& rho) const;

  /// `Closing_constraints::defect()`
  double period_defect(const Eigen::MatrixX3d& edges) const { return m_closing.defect(edges); }

 private:
  Result constrained(const Eigen::VectorXd& raw, const Grounded_solver<SolverTraits>& laplacian);
  Eigen::VectorXd filtered(const Eigen::VectorXd& v);
  void require_one_per_vertex(const Eigen::VectorXd& v) const;

  const Mesh_view& m_mesh;
  Direction m_direction;
  Closing_constraints<SolverTraits, EigensolverTraits> m_closing;
  bool m_is_closed;
  std::optional<Curvature_filter<SolverTraits>> m_filter;
  std::string m_function;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/flow/Constrained_direction_templates.h>
#endif

#endif
