// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_ROBUST_SPIN_TRANSFORMATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_ROBUST_SPIN_TRANSFORMATION_H

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/delaunay_boundary.h>
#include <Conformal_geometry_processing/mesh/well_shaped_faces.h>
#include <Conformal_geometry_processing/operators/delaunay_operators.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief spin transformations of surfaces whose triangles are as bad as they may be: needles,
/// caps, area zero.
///
/// What `Spin_transformation` does with the operators of `delaunay_operators.h`, in the same units,
/// with the same branch of eigenvalues and the same conditions at a boundary. Where the mesh is
/// intrinsically Delaunay it finds the same surface. The vertices of a degenerate face end up where
/// the surface of its neighbours has them. `Closing_spin_transformation` keeps handles closed.
///
/// Area, centroid and certificate are those of the `well_shaped_faces()` of the mesh, which leave
/// out the thinnest, at most 5 % of the area.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits>
class Robust_spin_transformation {
 public:
  using Dirac_equation_ = Surface_dirac_equation<SolverTraits, EigensolverTraits, Delaunay_view>;

  /// \param mesh is copied
  /// \param mollification see `mollified_lengths()`
  /// \param function named in exceptions
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with finite
  /// coordinates, if all of its faces have area zero, or mollification is not in (0, 1)
  /// \throw Solver_error if the analysis fails
  explicit Robust_spin_transformation(const Mesh_view& mesh, double mollification = 1e-6,
                                      const std::string& function = "Robust_spin_transformation");

  /// \brief the same with a condition for the boundary; the default is a free one.
  /// \param carries_generators whether `view()` has forms, which are `closed_generators()` of the
  /// mesh: as many numbers per edge as there are loops around handles and holes
  /// \throw Precondition_error too if the condition does not fit the mesh, see
  /// `require_condition()`
  Robust_spin_transformation(const Mesh_view& mesh, Boundary_condition condition,
                             double mollification, const std::string& function,
                             bool carries_generators = false);

  Robust_spin_transformation(const Robust_spin_transformation&) = delete;
  Robust_spin_transformation& operator=(const Robust_spin_transformation&) = delete;

  /// \brief the mesh has moved: `transform()` starts from there, on a triangulation of its own.
  ///
  /// Costs what the constructor does, for another triangulation has another pattern; while the new
  /// one is made, the old one and its factors are still there.
  /// \param positions 3 x |V|
  /// \throw Precondition_error if their number is another, one is not finite, all faces have area
  /// zero, the boundary folds back where directions are prescribed, or has prescribed
  /// positions; everything is as before then
  /// \throw Solver_error if the analysis fails; everything is as before then
  void set_positions(const Points& positions);

  /// the triangulation, in the frame of the computation; its forms, if it carries any, are
  /// `closed_generators()`
  const Delaunay_view& view() const { return m_state->view; }

  /// the unit of the frame
  double unit() const { return m_state->frame.unit(); }

  /// the Dirac equation of the triangulation
  const Dirac_equation_& dirac_equation() const { return m_state->dirac; }
  Dirac_equation_& dirac_equation() { return m_state->dirac; }

  /// \brief finds positions from edge vectors of the triangulation, in the frame of the
  /// computation.
  ///
  /// Factors the Laplacian the first time.
  /// \throw Solver_error if it cannot be factored
  const Poisson_reconstruction<SolverTraits, Delaunay_view>& reconstruction();

  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  void require_potential(const Curvature_potential& rho) const;

  /// \param rho in 1/length of the mesh, one number per vertex or per face of the mesh
  /// \param options as for `Spin_transformation`
  /// \param go_further asked between iterations with an `Eigensolver_progress`; false cancels
  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  /// \throw Solver_error if a factorization fails. No convergence is a field of the report.
  Spin_result transform(const Curvature_potential& rho, const Dirac_options& options = {},
                        const Go_further& go_further = Always_go_further()) &;

  /// the same for the last time: needs less memory, for the two factors are not there together
  Spin_result transform(const Curvature_potential& rho, const Dirac_options& options = {},
                        const Go_further& go_further = Always_go_further()) &&;

 private:
  /// what belongs to the present positions
  struct State {
    State(const Mesh_view& mesh_, const Robust_spin_transformation& of);

    State(const State&) = delete;
    State& operator=(const State&) = delete;

    Stopwatch watch;
    Normalized_frame frame;
    Mesh_view mesh;  // in the frame
    Delaunay_view view;
    Well_shaped_faces measured;
    Dirac_equation_ dirac;
    std::optional<Poisson_reconstruction<SolverTraits, Delaunay_view>> poisson;
    double seconds;  // that all of this took
  };

  static Boundary_condition checked(Boundary_condition condition, const Delaunay_view& view,
                                    const std::string& function);

  /// positions in the frame; directions are the same there
  Boundary_condition in_frame(const Normalized_frame& frame) const;
  Spin_report::Mollification mollification() const;

  /// lambda, with the part of the report that tells of it and of the triangulation
  Spin_result solve(const Curvature_potential& rho, Dirac_options options,
                    const Go_further& go_further);
  void reconstruct(Spin_result& result);

  std::string m_function;
  double m_mollification;
  Boundary_condition m_condition;
  Eigen::MatrixXd m_generators;
  std::unique_ptr<State> m_state;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Robust_spin_transformation_templates.h>
#endif

#endif
