// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_SPIN_TRANSFORMATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_SPIN_TRANSFORMATION_H

#include <Conformal_geometry_processing/flow/Moving_delaunay_view.h>
#include <Conformal_geometry_processing/flow/Moving_mesh.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// how a surface with handles is kept closed
struct Closing_options {
  /// how the constraints are discretised; none: one step, and the handles are sheared
  std::optional<Exactness> exactness = Exactness::adjoint;
  double max_period_defect = 0.02;  ///< relative to the edges, of all steps together
  double min_step = 1. / 256;       ///< the least share of rho that is worth a step
};

/// \ingroup PkgFlow
/// \brief spin transformations of surfaces with any number of handles and holes by any rho: applies
/// the part of rho with which the surface stays closed around them, in as many steps as that takes
/// [CGP 4.5.2].
///
/// The edges of a transformed surface have periods along the 2G loops of its handles, and where a
/// surface is made to close all the same, it is sheared. To first order the periods vanish if rho
/// is orthogonal to 6G functions (`exactness_constraints()`), so what is left falls with the square
/// of the step. Each step is as large as the tolerance allows, and the next one goes on from the
/// surface found towards the curvature that is missing: rho |df|, rho as a density of lengths, is
/// what adds up over transformations.
///
/// On spheres and disks it does what `Spin_transformation` does, and nothing else. Otherwise a step
/// costs a second factorization, of the matrix for rho = 0, and 10G solves or so.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
/// \tparam Moving `Moving_mesh`, or `Moving_delaunay_view` for faces as thin as they may be
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits,
          template <class, class> class Moving = Moving_mesh>
class Closing_spin_transformation {
  using Surface = Moving<SolverTraits, EigensolverTraits>;

 public:
  /// \param mesh must outlive the object
  /// \param function named in exceptions
  /// \throw Precondition_error as `Spin_transformation` does
  /// \throw Solver_error if the analysis fails
  explicit Closing_spin_transformation(const Mesh_view& mesh, const Closing_options& options = {},
                                       const std::string& function = "Closing_spin_transformation");

  /// the same with a condition for the boundary
  Closing_spin_transformation(const Mesh_view& mesh, const Closing_options& options,
                              const Boundary_condition& condition, const std::string& function);

  /// \brief the same of a `Robust_spin_transformation`, with `Moving_delaunay_view`.
  /// \param mollification see `mollified_lengths()`
  Closing_spin_transformation(const Mesh_view& mesh, const Closing_options& options,
                              const Boundary_condition& condition, double mollification,
                              const std::string& function);

  /// \brief transforms the mesh; the object is used up.
  ///
  /// Where not all of rho can be reached, the report tells which share (`reached`).
  /// \param rho in 1/length of the mesh, one number per vertex or per face
  /// \param go_further asked between iterations with an `Eigensolver_progress`; false cancels
  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  /// \throw Solver_error if a factorization fails. No convergence is a field of the report.
  Spin_result transform(const Curvature_potential& rho, const Dirac_options& options = {},
                        const Go_further& go_further = Always_go_further()) &&;

 private:
  bool has_loops();
  void go_all_the_way(Surface& surface, const Dirac_options& options, const Go_further& go_further,
                      Spin_result& all);

  /// root of the integral of rho squared, less its mean where that has no effect; does not depend
  /// on scale
  double norm(const Eigen::VectorXd& rho, const Eigen::VectorXd& A) const;

  /// \brief tries `step` times v and smaller steps, until one is good enough to go there.
  /// \returns none if no step of the least size is, or the visitor said no
  std::optional<Spin_result> largest_step(const Surface& surface, const Eigen::VectorXd& v,
                                          const Dirac_options& options,
                                          const Go_further& go_further, Spin_report& all,
                                          double& step);
  bool can_go_on_from(const Points& positions);
  double best_step(double step, double defect) const;
  double next_step(double step, double defect, double rest) const;

  /// \brief counts from the surface found, where rho becomes another one, as a density of lengths.
  ///
  /// What was not closable before is given up: to try it again, with ever less of the way left to
  /// make up for it, would end in ever faster steps.
  void take(const Spin_result& next, const Eigen::VectorXd& v, double share, Surface& surface);
  static Quaternion_vector<double> product(const Quaternion_vector<double>& first,
                                           const Quaternion_vector<double>& second);

  /// the evidence for the whole way
  static void measure(const Mesh_view& before, const Surface& after, Spin_result& all);

  Closing_options m_options;
  typename Surface::Transformation m_transformation;
  const Mesh_view& m_initial;
  Curvature_potential m_missing;  // rho that is to come, on the present surface
  Eigen::VectorXd m_left_out;     // rho that cannot come
};

/// \ingroup PkgFlow
/// the same for surfaces whose faces may be as thin as they like, or have area zero
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits>
using Robust_closing_spin_transformation =
    Closing_spin_transformation<SolverTraits, EigensolverTraits, Moving_delaunay_view>;

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/flow/Closing_spin_transformation_templates.h>
#endif

#endif
