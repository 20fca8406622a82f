// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_NEAREST_SPIN_TRANSFORMATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_NEAREST_SPIN_TRANSFORMATION_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// a conformal deformation near to a given one, or between the two
struct Nearest_spin_result : Spin_result {
  double distance = 0;  ///< root mean square of the distances of the vertices from the target, by
                        ///< the diagonal of its bounding box
};

/// \ingroup PkgSpin
/// how a target is approached
struct Nearest_spin_options {
  /// direction of the boundary frame (T, N, B) that becomes that of the target; the binormal,
  /// unlike the tangent, can be realised whatever the target is
  Eigen::Vector3d direction{1, 0, 0};
  std::optional<Exactness> exactness = Exactness::adjoint;  ///< see `Spin_transformation_options`
  /// see `Spin_transformation_options`; spins of thin faces, of the mesh or of the target, are then
  /// taken from their neighbours, and the spin structure of the target is not checked
  std::optional<double> mollification = std::nullopt;
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
  /// \throw Precondition_error if the mesh, or the target with its connectivity, is not a
  /// connected, oriented manifold with finite coordinates and, without mollification, positive
  /// areas; or if the target of a closed mesh is of another spin structure
  /// \throw Solver_error if the analysis fails
  Nearest_spin_transformation(const Mesh_view& mesh, Points target,
                              const std::string& function = "Nearest_spin_transformation",
                              const Nearest_spin_options& options = {});

  /// \brief the deformation that spins mu describe, conjugate(mu) df mu, as of a field of
  /// rotations. The target is what they integrate to.
  /// \param mu |V|, continuous in sign
  /// \throw Precondition_error if their number is another, one is not finite, or what they
  /// integrate to has faces of area zero
  Nearest_spin_transformation(const Mesh_view& mesh, const Quaternion_vector<double>& mu,
                              const std::string& function = "Nearest_spin_transformation",
                              const Nearest_spin_options& options = {});

  /// \brief scales lengths by `factor` as well, one positive number per vertex; before
  /// `transform()`.
  /// \throw Precondition_error if their number is another, or one is not positive and finite
  void scale_lengths(const Eigen::VectorXd& factor);

  /// the spins of the target, |V|; they need not belong to a surface
  const Quaternion_vector<double>& target_spins() const { return m_mu; }

  /// their change of curvature, in 1/length, on faces
  const Curvature_potential& potential() const { return m_rho; }

  /// see `make_consistent()`
  int sign_conflicts() const { return m_conflicts; }

  /// \brief the conformal deformation.
  /// \throw Solver_error if a factorization fails. No convergence is a field of the report.
  Nearest_spin_result transform(const Dirac_options& options = {},
                                const Go_further& go_further = Always_go_further());

  /// \brief the surface of (1 - t) lambda + t mu, which is conformal for t = 0 only.
  /// \param nearest of `transform()`
  Nearest_spin_result blend(const Nearest_spin_result& nearest, double t);

 private:
  Nearest_spin_transformation(const std::string& function, const Mesh_view& mesh, Points target,
                              const Nearest_spin_options& options);
  void use(Quaternion_vector<double> mu);
  static Points integrated(const Mesh_view& mesh, const Quaternion_vector<double>& mu,
                           const std::string& function, const Nearest_spin_options& options);
  static Points checked(const Mesh_view& mesh, Points target, const std::string& function,
                        const Nearest_spin_options& options);
  static Spin_transformation_options transformation_options(const Mesh_view& target,
                                                            const Nearest_spin_options& options);

  /// \brief multiplies lambda from the right by the constant that brings it nearest to mu: a
  /// rotation and a scaling of the surface; where directions are prescribed, a scaling only.
  void align_spins(Quaternion_vector<double>& lambda) const;
  Nearest_spin_result placed(Spin_result found) const;

  Points m_target;
  Spin_transformation<SolverTraits, EigensolverTraits> m_transformation;
  int m_conflicts = 0;
  Quaternion_vector<double> m_mu;
  Curvature_potential m_rho;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation_templates.h>
#endif

#endif
