// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/Visit_guard.h>

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief how far surfaces are from a target with the same faces, in positions and in normals, both
/// relative to the mesh that is to be deformed.
///
/// Positions alone do not tell what one sees: conformal surfaces come as near as one likes to any
/// surface in their positions, by ever finer wrinkles, whose normals stay far from those of it.
class Target_mismatch {
 public:
  struct Value {
    /// onto the target, with the root mean square distance of the vertices, weighted by areas and
    /// relative to the diagonal
    Alignment alignment;
    /// root mean square of |n - n'| for the unit normals n, n' of the faces, weighted by the areas
    /// of the target: for small angles these in radians, at most 2
    double normals = 0;
  };

  /// \param mesh that is to be deformed
  /// \param target 3 x |V|
  /// \param areas of the vertices
  /// \param normal_weight w
  /// \param tolerance a distance that nobody sees, relative to the diagonal
  /// \throw Precondition_error unless w and the tolerance are finite and at least 0
  Target_mismatch(const Mesh_view& mesh, Points target, Eigen::VectorXd areas, double normal_weight,
                  double tolerance);

  /// of a surface, 3 x |V|, anywhere in space and of any size
  Value operator()(const Points& positions) const;

  /// that of the mesh itself
  const Value& source() const { return m_source; }

  /// \brief (d / d_0)^2 + w (n / n_0)^2 for the distances d of positions and n of normals, with
  /// d_0, n_0 those of the mesh itself.
  ///
  /// A mesh that is the target has d_0 = 1e-9, and one of the same normals n_0 = 1e-3.
  double sum(double d, double n) const;

  /// \brief whether d is within the tolerance e and, unless w = 0, n is within 100 e: that is how
  /// far details of 1 % of the diagonal turn which are displaced by e.
  bool is_reached(double d, double n) const;

 private:
  Mesh_view m_target;
  Normalized_frame m_frame;  // of the target, where squares of areas neither overflow nor underflow
  Eigen::VectorXd m_areas;
  Points m_normals;  // of the target, times twice the areas of faces, in the frame
  double m_normal_weight, m_tolerance;
  Value m_source;
};

class Relaxed_positions;

}  // namespace internal

/// \ingroup PkgSpin
/// a conformal deformation near a given one, or a blend of the two
struct Nearest_spin_result : Spin_result {
  /// root mean square distance of the vertices from the target, weighted by their areas, relative
  /// to the diagonal of its bounding box
  double distance = 0;
  double source_distance = 0;  ///< likewise that of the mesh
  /// root mean square of |n - n'| for the unit normals n of its faces and n' of the target's,
  /// weighted by the areas of the target: small angles in radians. Wrinkles raise it.
  double normal_distance = 0;
  double source_normal_distance = 0;  ///< likewise that of the mesh
  Curvature_potential rho;            ///< the change of curvature, in 1/length of the mesh
  /// the direction at the boundary that was taken from the target; none: it was left free, or there
  /// is none
  std::optional<Eigen::Vector3d> direction;
};

/// \ingroup PkgSpin
/// options of `Nearest_spin_transformation`
struct Nearest_spin_options {
  /// direction of the boundary frame (T, N, B) that is taken from the target; the binormal, unlike
  /// the tangent, can be realised for any target
  Eigen::Vector3d direction{1, 0, 0};
  /// what is requested of the result; the boundary is that of `direction`. With mollification,
  /// spins of thin faces, of the mesh or of the target, are taken from their neighbours, and the
  /// spin structure of the target is not checked
  Spin_transformation_options surface = {};
  /// whether the surface with the curvature of the target is the result [CGP 5.9], and not the
  /// start of a search for the nearest one
  bool keep_curvature = false;
  /// how much the normals count beside the positions, >= 0, see `internal::Target_mismatch`. With
  /// 0, a target that is far from conformal is approached by wrinkles
  double normal_weight = 1;
  /// how far from conformal it may be: the largest closure residual of what is found on the way, >
  /// 0; none: .05 or what the mesh asks for, and with the normal weight 0 the limit of the report
  std::optional<double> shear = std::nullopt;
  /// the search ends at this distance, relative to the diagonal, and a hundred times as many
  /// radians between normals: a tenth of a pixel of a picture of 1,000 pixels. What is left after
  /// that costs most of the time
  double distance_tolerance = 1e-4;
};

/// \ingroup PkgSpin
/// \brief finds the conformal deformation nearest to a given deformation, in the mean square
/// distance of the vertices after the best similarity, as far as the normals come nearer with it.
///
/// Starts from the spin transformation with the same curvature and, on surfaces with boundary, the
/// same tangents or another direction of the boundary [CGP 5.9, 6.3], or from the mesh if that is
/// nearer, and searches on among conformal surfaces of other curvature, see
/// `internal::Relaxed_positions`. The result is never farther from the target than the mesh.
/// Where the directions at the boundary lead to no such surface, it is tried with others: the
/// binormals, the tangents, and in the end none.
///
/// The rotations and scalings of the faces are averaged to spins mu of the vertices, which in
/// general are not the spins of any surface: integrating them directly causes a shear that
/// refinement does not remove. Their curvature is that of a conformal deformation, the start of the
/// search. (1 - t) lambda + t mu interpolates between its result and the target.
///
/// A similarity aligns the results with the target as closely as possible.
class Nearest_spin_transformation {
 public:
  /// \param mesh is copied
  /// \param target positions of the deformed surface, 3 x |V|
  /// \param function named in exceptions
  /// \throw Precondition_error if the mesh, or the target with its connectivity, is not a
  /// connected, oriented manifold with finite coordinates and, without mollification, positive
  /// areas; or if the target of a closed mesh has another spin structure
  /// \throw Solver_error if the analysis fails
  Nearest_spin_transformation(const Mesh_view& mesh, Points target,
                              const std::string& function = "Nearest_spin_transformation",
                              const Nearest_spin_options& options = {});

  /// \brief takes the deformation from spins mu, conjugate(mu) df mu, for example of a field of
  /// rotations. The target is the surface that results from integrating them.
  /// \param mu |V|, continuous in sign
  /// \throw Precondition_error if their number is wrong, one is not finite, or the integrated
  /// surface has faces of area zero
  Nearest_spin_transformation(const Mesh_view& mesh, const Quaternion_vector<double>& mu,
                              const std::string& function = "Nearest_spin_transformation",
                              const Nearest_spin_options& options = {});

  /// \brief additionally scales lengths by `factor`, one positive number per vertex; must be called
  /// before `transform()`, which then keeps the curvature of these spins, see `keep_curvature`.
  /// \throw Precondition_error if their number is wrong, or one is not positive and finite
  void scale_lengths(const Eigen::VectorXd& factor);

  /// the spins of the target, |V|; in general not the spins of any surface
  const Quaternion_vector<double>& target_spins() const { return m_mu; }

  /// the change of curvature by the target spins, in 1/length, on faces
  const Curvature_potential& potential() const { return m_rho; }

  /// number of sign conflicts, see `make_consistent()`
  int sign_conflicts() const { return m_conflicts; }

  /// \brief the conformal deformation.
  /// \throw Precondition_error if `go_further` calls back one of the functions that compute
  /// \throw Solver_error if a factorization fails. Failure to converge is a field of the report.
  Nearest_spin_result transform(
      const internal::Go_further& go_further = internal::Always_go_further());

  /// \brief the surface of (1 - t) lambda + t mu, which is conformal only for t = 0.
  /// \param nearest result of `transform()`
  Nearest_spin_result blend(const Nearest_spin_result& nearest, double t);

 private:
  using Search = internal::Relaxed_positions;

  Nearest_spin_transformation(const std::string& function, const Mesh_view& mesh, Points target,
                              const Nearest_spin_options& options);
  void use(Quaternion_vector<double> mu);

  /// prescribes a direction at the boundary, or leaves it free
  void use_boundary(const std::optional<Eigen::Vector3d>& direction);

  /// the best result with the present boundary condition
  Nearest_spin_result transform_once(const internal::Go_further& go_further);

  /// \brief what `internal::Relaxed_positions` find from `start`, or `start`, with the costs of
  /// both: minimises
  ///
  ///     |(D - rho') lambda|^2_W + |rho' - rho|^2_K + w / R^2 distance^2
  ///
  /// with the mean square distance of vertices from targets after the best similarity.
  ///
  /// The weight w grows as long as surfaces verify, are within a bound on lengths, and the mismatch
  /// of positions and normals together falls (`internal::Target_mismatch`), or until nobody sees
  /// the rest, or the edges close up worse than those of conformal surfaces of such a mesh: what is
  /// far from conformal would be approached by shear, and by wrinkles that the mesh cannot
  /// represent. Where that fails, w grows less.
  Nearest_spin_result searched(Nearest_spin_result start, const internal::Go_further& go_further);

  /// a search that is at `start`
  std::unique_ptr<Search> positions_from(const Nearest_spin_result& start);

  /// where a search is, with its costs since the last call
  Nearest_spin_result present(Search& search);

  bool is_better(const Nearest_spin_result& next, const Nearest_spin_result& best) const;

  /// the mesh, moved to the target
  Nearest_spin_result unchanged();

  static Points integrated(const Mesh_view& mesh, const Quaternion_vector<double>& mu,
                           const std::string& function, const Nearest_spin_options& options);
  static Spin_transformation_options transformation_options(
      const Mesh_view& target, const Nearest_spin_options& options,
      const std::optional<Eigen::Vector3d>& direction);

  /// \brief multiplies lambda from the right by the constant that brings it nearest to mu: a
  /// rotation and a scaling of the surface; only a scaling if directions are prescribed.
  void align_spins(Quaternion_vector<double>& lambda) const;
  Nearest_spin_result placed(Spin_result found, Curvature_potential rho) const;

  std::string m_function;
  internal::Visit_guard m_visits;
  Nearest_spin_options m_options;
  Points m_target;
  std::optional<Eigen::Vector3d> m_direction;  // of the present transformation
  std::unique_ptr<Spin_transformation> m_transformation;
  internal::Target_mismatch m_mismatch;
  int m_conflicts = 0;
  Quaternion_vector<double> m_mu;
  Curvature_potential m_rho;
};

}  // namespace Conformal_geometry_processing
