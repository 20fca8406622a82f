// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_NEAREST_SPIN_TRANSFORMATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_NEAREST_SPIN_TRANSFORMATION_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_of_spins.h>
#include <Conformal_geometry_processing/spin/face_spins.h>
#include <Conformal_geometry_processing/spin/spin_structure.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// a conformal deformation near to a given one, or between the two
struct Nearest_spin_result : Spin_result {
  double distance = 0;  ///< root mean square of the distances of the vertices from the target, by
                        ///< the diagonal of its bounding box
};

/// \ingroup PkgSpin
/// \brief finds the conformal deformation of a surface that is nearest to a given deformation: a
/// spin transformation that has its curvature and, on surfaces with boundary, its tangents or
/// another direction of its boundary [CGP 5.9, 6.3].
///
/// The rotations and scalings of the faces become spins mu of the vertices, which in general belong
/// to no surface: integrated directly they leave a shear that no refinement takes away. Their
/// curvature rho is that of a conformal deformation, whose spins lambda are found from it. Between
/// them lies (1 - t) lambda + t mu.
///
/// Results are placed, turned and scaled to lie as near to the target as they can.
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits>
class Nearest_spin_transformation {
 public:
  /// \param mesh is copied
  /// \param target positions of the deformed surface, 3 x |V|
  /// \param function named in exceptions
  /// \param direction of the boundary frame (T, N, B) that becomes that of the target; the
  /// binormal, unlike the tangent, can be realised whatever the target is
  /// \throw Precondition_error if the mesh, or the target with its connectivity, is not a
  /// connected, oriented manifold with finite coordinates and positive areas; or if the target of a
  /// closed mesh is of another spin structure
  /// \throw Solver_error if the analysis fails
  Nearest_spin_transformation(const Mesh_view& mesh, Points target,
                              const std::string& function = "Nearest_spin_transformation",
                              const Eigen::Vector3d& direction = {1, 0, 0})
      : Nearest_spin_transformation(function, mesh, checked(mesh, std::move(target), function),
                                    direction)
  {
    Quaternion_vector<double> faces = face_spins(mesh, m_target);
    m_conflicts = make_consistent(mesh, faces);
    use(mesh, vertex_spins(mesh, faces));
  }

  /// \brief the deformation that spins mu describe, conjugate(mu) df mu, as of a field of
  /// rotations. The target is what they integrate to.
  /// \param mu |V|, continuous in sign
  /// \throw Precondition_error if their number is another, one is not finite, or what they
  /// integrate to has faces of area zero
  Nearest_spin_transformation(const Mesh_view& mesh, const Quaternion_vector<double>& mu,
                              const std::string& function = "Nearest_spin_transformation")
      : Nearest_spin_transformation(mesh, integrated(mesh, mu, function), function)
  {
    m_conflicts = 0;
    use(mesh, mu);
  }

  /// \brief scales lengths by `factor` as well, one positive number per vertex; before
  /// `transform()`.
  /// \throw Precondition_error if their number is another, or one is not positive and finite
  void scale_lengths(const Mesh_view& mesh, const Eigen::VectorXd& factor)
  {
    const std::string function = "Nearest_spin_transformation::scale_lengths";
    if (factor.size() != m_mu.size())
      throw Precondition_error(
          function, std::to_string(factor.size()) +
                        " factors, one per vertex is needed: " + std::to_string(m_mu.size()));
    internal::refuse_if_any(
        static_cast<int>(factor.size()),
        [&](int v) { return !(factor[v] > 0) || !std::isfinite(factor[v]); },
        internal::name_of_vertex, function, "#factor not positive", "positive ones are needed");
    Quaternion_vector<double> scaled = m_mu;
    for (Eigen::Index v = 0; v < scaled.size(); ++v) scaled[v] *= std::sqrt(factor[v]);
    use(mesh, std::move(scaled));
  }

  /// the spins of the target, |V|; they need not belong to a surface
  const Quaternion_vector<double>& target_spins() const { return m_mu; }

  /// their change of curvature, in 1/length, on faces
  const Curvature_potential& potential() const { return m_rho; }

  /// see `make_consistent()`
  int sign_conflicts() const { return m_conflicts; }

  /// \brief the conformal deformation.
  /// \throw Solver_error if a factorization fails. No convergence is a field of the report.
  Nearest_spin_result transform(const Dirac_options& options = {}, const Go_further& go_further = Always_go_further())
  {
    Spin_result found = m_transformation.transform(m_rho, options, go_further);
    if (found.report.cancelled) return {std::move(found), 0};
    align_spins(found.lambda);
    return placed(std::move(found));
  }

  /// \brief the surface of (1 - t) lambda + t mu, which is conformal for t = 0 only.
  /// \param nearest of `transform()`
  Nearest_spin_result blend(const Nearest_spin_result& nearest, double t)
  {
    Quaternion_vector<double> spins = nearest.lambda;
    align_spins(spins);
    for (Eigen::Index v = 0; v < spins.size(); ++v) spins[v] = spins[v] * (1 - t) + m_mu[v] * t;
    Spin_result between = m_transformation.integrate(std::move(spins));
    tell_equation(nearest.report, between.report);
    return placed(std::move(between));
  }

 private:
  Nearest_spin_transformation(const std::string& function, const Mesh_view& mesh, Points target,
                              const Eigen::Vector3d& direction)
      : m_target(std::move(target)),
        m_transformation(mesh, boundary_condition(mesh, m_target, direction), function),
        m_areas(vertex_areas(mesh)),
        m_is_closed(m_transformation.dirac_equation().is_closed())
  {}

  void use(const Mesh_view& mesh, Quaternion_vector<double> mu)
  {
    m_mu = std::move(mu);
    m_rho = curvature_of_spins(mesh, m_mu);
  }

  static Points integrated(const Mesh_view& mesh, const Quaternion_vector<double>& mu,
                           const std::string& function)
  {
    return Spin_transformation<SolverTraits, EigensolverTraits>(mesh, function)
        .integrate(mu)
        .positions;
  }

  static Points checked(const Mesh_view& mesh, Points target, const std::string& function)
  {
    require_surface(mesh, function);
    if (target.cols() != mesh.size_of_vertices())
      throw Precondition_error(function, std::to_string(target.cols()) +
                                             " target positions, one per vertex is needed: " +
                                             std::to_string(mesh.size_of_vertices()));
    const Mesh_view deformed(target, mesh.corners());
    require_finite_positions(deformed, function + ", target");
    require_positive_areas(deformed, function + ", target");
    if (boundary_loops(mesh).empty()) require_same_spin_structure(mesh, target, function);
    return target;
  }

  static Boundary_condition boundary_condition(const Mesh_view& mesh, const Points& target,
                                               const Eigen::Vector3d& direction)
  {
    const Boundary_frames frames = boundary_frames({target, mesh.corners()});
    if (frames.vertices.empty()) return Boundary_condition::free();
    Points targets(3, static_cast<Eigen::Index>(frames.vertices.size()));
    for (std::size_t k = 0; k < frames.vertices.size(); ++k)
      targets.col(static_cast<Eigen::Index>(k)) = frames.frames[k] * direction;
    return Boundary_condition::directions(direction, std::move(targets));
  }

  /// what a report says about the Dirac equation, which was solved for lambda
  static void tell_equation(const Spin_report& from, Spin_report& to)
  {
    to.eigenvalue = from.eigenvalue;
    to.residual = from.residual;
    to.gap = from.gap;
    to.overlap = from.overlap;
    to.iterations = from.iterations;
    to.substeps = from.substeps;
    to.spectral_shift = from.spectral_shift;
  }

  /// \brief multiplies lambda from the right by the constant that brings it nearest to mu: a
  /// rotation and a scaling of the surface; where directions are prescribed, a scaling only.
  void align_spins(Quaternion_vector<double>& lambda) const
  {
    Quaternion<double> c =
        inner_product(lambda, m_areas, m_mu) / inner_product(lambda, m_areas, lambda).w;
    if (!m_is_closed) c = {c.w, 0, 0, 0};
    for (Quaternion<double>& q : lambda) q = q * c;
  }

  Nearest_spin_result placed(Spin_result found) const
  {
    Nearest_spin_result result{std::move(found), 0};
    if (!result.report.converged) return result;
    const Alignment a = align(result.positions, m_target);
    result.positions = a.apply(result.positions);
    result.distance = a.rms;
    return result;
  }

  Points m_target;
  Spin_transformation<SolverTraits, EigensolverTraits> m_transformation;
  Eigen::VectorXd m_areas;
  bool m_is_closed;
  int m_conflicts = 0;
  Quaternion_vector<double> m_mu;
  Curvature_potential m_rho;
};

}  // namespace Conformal_geometry_processing

#endif
