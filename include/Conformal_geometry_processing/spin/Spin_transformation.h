// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_TRANSFORMATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_TRANSFORMATION_H

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/Surface_dirac_equation.h>
#include <Conformal_geometry_processing/spin/certify.h>
#include <Conformal_geometry_processing/spin/report_of_solution.h>
#include <Conformal_geometry_processing/spin/require_potential.h>
#include <Conformal_geometry_processing/spin/restore_area.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

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
                               const std::string& function = "Spin_transformation")
      : Spin_transformation(mesh, Boundary_condition(), function)
  {}

  /// \brief the same with a condition for the boundary; the default is a free one.
  /// \throw Precondition_error too if the condition does not fit the mesh, see
  /// `require_condition()`
  Spin_transformation(const Mesh_view& mesh, const Boundary_condition& condition,
                      const std::string& function = "Spin_transformation")
      : m_function(function),
        m_frame(checked(mesh, condition, function).positions()),
        m_mesh(mesh),
        m_dirac(in_frame(m_mesh, m_frame), in_frame(condition), function),
        m_setup_seconds(m_watch.lap())
  {}

  Spin_transformation(const Spin_transformation&) = delete;
  Spin_transformation& operator=(const Spin_transformation&) = delete;

  /// \brief the mesh has moved, as in the steps of a flow: `transform()` starts from there.
  ///
  /// Nothing is ordered or analyzed again. With `Lagged_solver_traits`, the factors are kept for as
  /// long as that pays.
  /// \param positions 3 x |V|
  /// \throw Precondition_error if their number is another, one is not finite or a face has area
  /// zero, or the boundary has prescribed positions; everything is as before then
  void set_positions(const Points& positions)
  {
    require_size(positions.cols(), "positions");
    if (m_dirac.positions())
      throw Precondition_error(m_function, "a surface with prescribed boundary cannot move");
    const Points before = m_mesh.positions();
    m_mesh.set_positions(positions);
    try {
      require_finite_positions(m_mesh, m_function);
      require_positive_areas(m_mesh, m_function);
    } catch (...) {
      m_mesh.set_positions(before);
      throw;
    }
    m_frame = Normalized_frame(positions);
    in_frame(m_mesh, m_frame);
    m_dirac.update_geometry();
    m_has_moved = true;
  }

  using Dirac_equation_ = Surface_dirac_equation<SolverTraits, EigensolverTraits>;

  /// the Dirac equation of the mesh, in the frame of the computation
  const Dirac_equation_& dirac_equation() const { return m_dirac; }
  Dirac_equation_& dirac_equation() { return m_dirac; }

  /// \brief finds positions from edge vectors, in the frame of the computation.
  /// \throw Solver_error if the Laplacian cannot be factored
  const Poisson_reconstruction<SolverTraits>& reconstruction()
  {
    const auto& dirac = m_dirac.problem();
    if (!m_reconstruction)
      m_reconstruction.emplace(m_mesh, dirac.matrix().shared_pattern(), dirac.solver());
    else if (m_has_moved)
      m_reconstruction->update_geometry();
    m_has_moved = false;
    return *m_reconstruction;
  }

  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  void require_potential(const Curvature_potential& rho) const
  {
    Conformal_geometry_processing::require_potential(m_mesh, rho, m_frame.unit(), m_function);
  }

  /// \param rho in 1/length of the mesh, one number per vertex or per face
  /// \param go_further asked between iterations with an `Eigen_progress`; false cancels
  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  /// \throw Solver_error if a factorization fails. No convergence is a field of the report.
  Spin_result transform(const Curvature_potential& rho, const Dirac_options& options = {},
                        const Go_further& go_further = Always_go_further()) &
  {
    Spin_result result = solve(rho, options, go_further);
    if (!result.report.cancelled) reconstruct(result);
    return result;
  }

  /// the same for the last time: needs less memory, for the two factors are not there together
  Spin_result transform(const Curvature_potential& rho, const Dirac_options& options = {},
                        const Go_further& go_further = Always_go_further()) &&
  {
    Spin_result result = solve(rho, options, go_further);
    m_dirac.release();
    if (!result.report.cancelled) reconstruct(result);
    return result;
  }

  /// \brief the surface with given spins, whether they solve a Dirac equation or not.
  ///
  /// `report.closure_residual` tells how far they are from spins of a surface; `converged` whether
  /// all numbers are finite.
  /// \param lambda |V|
  /// \throw Precondition_error if their number is another
  /// \throw Solver_error if the Laplacian cannot be factored
  Spin_result integrate(Quaternion_vector<double> lambda)
  {
    require_size(lambda.size(), "spins");
    Spin_result result;
    result.lambda = std::move(lambda);
    result.report.converged = true;
    reconstruct(result);
    return result;
  }

 private:
  static const Mesh_view& checked(const Mesh_view& mesh, const Boundary_condition& condition,
                                  const std::string& function)
  {
    require_surface(mesh, function);
    require_condition(mesh, condition, function);
    return mesh;
  }

  /// positions in the frame; directions are the same there
  Boundary_condition in_frame(Boundary_condition condition) const
  {
    if (condition.kind == Boundary_condition::Kind::positions)
      condition.targets = m_frame.to_frame(std::move(condition.targets));
    return condition;
  }

  static const Mesh_view& in_frame(Mesh_view& mesh, const Normalized_frame& frame)
  {
    mesh.set_positions(frame.to_frame(mesh.positions()));
    return mesh;
  }

  void require_size(Eigen::Index size, const std::string& what) const
  {
    if (size != m_mesh.size_of_vertices())
      throw Precondition_error(m_function, std::to_string(size) + " " + what +
                                               ", one per vertex is needed: " +
                                               std::to_string(m_mesh.size_of_vertices()));
  }

  /// lambda, with the part of the report that tells of it
  Spin_result solve(const Curvature_potential& rho, Dirac_options options, const Go_further& go_further)
  {
    require_potential(rho);
    options.kernel_tolerance *= m_frame.unit();
    const Curvature_potential rho_in_frame{rho.on, rho.values * m_frame.unit()};
    Dirac_solution s = m_dirac.solve(rho_in_frame, options, go_further);
    Spin_result result;
    result.report = report_of(s, m_frame.unit());
    result.report.seconds.setup = m_setup_seconds;
    result.lambda = std::move(s.lambda);
    return result;
  }

  /// Positions from lambda, with the area and the centroid of the mesh, and the certificate.
  void reconstruct(Spin_result& result)
  {
    Stopwatch watch;
    Spin_report& r = result.report;
    const Eigen::MatrixX3d edges = transformed_edges(m_mesh, result.lambda);
    Points f = m_dirac.positions() ? m_dirac.positions()->positions(edges)
                                   : reconstruction().positions(edges);
    r.closure_residual = reconstruction().residual(f, edges);
    r.seconds.reconstruction = watch.lap();
    if (!m_dirac.positions()) restore_area(m_mesh, f, result.lambda);
    result.positions = m_frame.from_frame(f);
    f = m_frame.to_frame(result.positions);  // as they are rounded
    internal::certify(m_mesh, f, result.lambda, r);
    const auto moved = [&] { return Mesh_view(f, m_mesh.corners()); };
    internal::judge_boundary(m_mesh, moved, f.allFinite(), m_dirac, m_frame.unit(), r);
    r.seconds.certificate = watch.lap();
  }

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

#endif
