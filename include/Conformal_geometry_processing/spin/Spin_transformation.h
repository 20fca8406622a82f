// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_TRANSFORMATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_TRANSFORMATION_H

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/Surface_dirac_equation.h>
#include <Conformal_geometry_processing/spin/require_potential.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// the transformed surface with its report
struct Spin_result {
  Points positions;                  ///< 3 x |V|
  Quaternion_vector<double> lambda;  ///< |V|; df~ = conjugate(lambda) df lambda
  Spin_report report;
};

/// \ingroup PkgSpin
/// \brief spin transformations of one surface: prescribes a change rho of its mean curvature, and
/// on surfaces with boundary what becomes of that, and finds the conformally equivalent surface
/// that has it [CGP (5.3)-(5.5), 5.7].
///
/// H~ |lambda|^2 = H + rho + gamma, so positive rho bulges along the normals. The result has the
/// area and the centroid of the mesh, unless positions are prescribed. All that depends on the mesh
/// alone is done once: checks, ordering and symbolic analysis in the constructor, the factorization
/// of the Laplacian when it is first needed. Every call of `transform()` costs one numeric
/// factorization of the Dirac matrix, three to eight solves with it, and one with the Laplacian.
///
/// Computes in a frame of unit size around the centre, so that neither scale nor position matter.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits>
class Spin_transformation {
 public:
  /// \param mesh is copied
  /// \param function named in exceptions
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with
  /// finite coordinates and positive areas; the message names the first element in the way
  /// \throw Solver_error if the analysis fails
  explicit Spin_transformation(const Mesh_view& mesh,
                               const std::string& function = "Spin_transformation");

  /// \brief the same with a condition for the boundary; the default is a free one.
  /// \throw Precondition_error too if the condition does not fit the mesh, see
  /// `require_condition()`
  Spin_transformation(const Mesh_view& mesh, const Boundary_condition& condition,
                      const std::string& function = "Spin_transformation");

  Spin_transformation(const Spin_transformation&) = delete;
  Spin_transformation& operator=(const Spin_transformation&) = delete;

  /// \brief the mesh has moved, as in the steps of a flow: `transform()` starts from there.
  ///
  /// Nothing is ordered or analyzed again. With `Lagged_solver_traits`, the factors are kept for as
  /// long as that pays.
  /// \param positions 3 x |V|
  /// \throw Precondition_error if their number is another, one is not finite or a face has area
  /// zero, or the boundary has prescribed positions; everything is as before then
  void set_positions(const Points& positions);

  using Dirac_equation_ = Surface_dirac_equation<SolverTraits, EigensolverTraits>;

  /// the Dirac equation of the mesh, in the frame of the computation
  const Dirac_equation_& dirac_equation() const { return m_dirac; }
  Dirac_equation_& dirac_equation() { return m_dirac; }

  /// \brief finds positions from edge vectors, in the frame of the computation.
  /// \throw Solver_error if the Laplacian cannot be factored
  const Poisson_reconstruction<SolverTraits>& reconstruction();

  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  void require_potential(const Curvature_potential& rho) const;

  /// \param rho in 1/length of the mesh, one number per vertex or per face
  /// \param go_further asked between iterations with an `Eigensolver_progress`; false cancels
  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  /// \throw Solver_error if a factorization fails. No convergence is a field of the report.
  Spin_result transform(const Curvature_potential& rho, const Dirac_options& options = {},
                        const Go_further& go_further = Always_go_further()) &;

  /// the same for the last time: needs less memory, for the two factors are not there together
  Spin_result transform(const Curvature_potential& rho, const Dirac_options& options = {},
                        const Go_further& go_further = Always_go_further()) &&;

  /// \brief the surface with given spins, whether they solve a Dirac equation or not.
  ///
  /// `report.closure_residual` tells how far they are from spins of a surface; `converged` whether
  /// all numbers are finite.
  /// \param lambda |V|
  /// \throw Precondition_error if their number is another
  /// \throw Solver_error if the Laplacian cannot be factored
  Spin_result integrate(Quaternion_vector<double> lambda);

 private:
  static const Mesh_view& checked(const Mesh_view& mesh, const Boundary_condition& condition,
                                  const std::string& function);

  /// positions in the frame; directions are the same there
  Boundary_condition in_frame(Boundary_condition condition) const;
  static const Mesh_view& in_frame(Mesh_view& mesh, const Normalized_frame& frame);
  void require_size(Eigen::Index size, const std::string& what) const;

  /// lambda, with the part of the report that tells of it
  Spin_result solve(const Curvature_potential& rho, Dirac_options options,
                    const Go_further& go_further);

  /// Positions from lambda, with the area and the centroid of the mesh, and the certificate.
  void reconstruct(Spin_result& result);

  Stopwatch m_watch;  // started before everything else is constructed
  std::string m_function;
  Normalized_frame m_frame;
  Mesh_view m_mesh;  // in the frame
  Dirac_equation_ m_dirac;
  std::optional<Poisson_reconstruction<SolverTraits>> m_reconstruction;
  bool m_has_moved = false;  // since the Laplacian was assembled
  double m_setup_seconds;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Spin_transformation_templates.h>
#endif

#endif
