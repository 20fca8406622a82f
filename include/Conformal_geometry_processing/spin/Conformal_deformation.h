// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Control_point.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/krylov/Visit_guard.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief weights in a `Region_of_interest` where something happens: 0 in those of its parts, faces
/// with a vertex of positive weight that are connected, that have no control point.
/// \param weights |V|, or empty, as is the result then
/// \throw Precondition_error see `require_control_points()`
Eigen::VectorXd weights_at(const std::vector<Control_point>& points, const Mesh_view& mesh,
                           Eigen::VectorXd weights, const std::string& function);

/// \throw Precondition_error if a weight, one per vertex, is not in [0, 1], or none is 1
void require_region(const Mesh_view& mesh, const Eigen::VectorXd& weights,
                    const std::string& function);

/// \brief the part of a surface that an edit may change, with a collar where the edit fades out.
///
/// Each vertex has a weight w: 1 follows the edit, 0 stays, to the bit. Those between are the
/// collar: they move by the share s = w^2 (3 - 2 w) of the edit's displacement, whose slope is zero
/// at both ends, so that normals are continuous. No displacement but a similarity is conformal and
/// fades out; the collar has the distortion, which falls with its width. The edit is made on the
/// faces with a vertex of positive weight alone, and anchors, control points that are where they
/// were, let it displace the collar little.
class Region_of_interest {
 public:
  /// \param weights |V|
  /// \throw as `require_region()`, and Precondition_error if the part is not connected
  Region_of_interest(const Mesh_view& mesh, const Eigen::VectorXd& weights,
                     const std::string& function);

  /// the faces with a vertex of positive weight
  const Mesh_view& mesh() const { return m_part.mesh; }

  /// the indices of its vertices in the whole mesh
  const std::vector<int>& vertices() const { return m_part.vertices; }

  /// what holds the collar, in the part; none if all weights are 1
  const std::vector<Control_point>& anchors() const { return m_anchors; }

  /// \brief control points of the whole mesh in the part.
  /// \throw Precondition_error if one has a vertex whose weight is not 1. The message names it
  std::vector<Control_point> in_part(std::vector<Control_point> points,
                                     const std::string& function) const;

  /// \brief fades out an edit of the part.
  /// \param positions, lambda of the edited part; where the weight is 0, the positions become those
  /// of the mesh, and lambda 1
  void fade(Points& positions, Quaternion_vector<double>& lambda) const;

  /// of the map from the faces of the collar to those with other positions of the part; none if all
  /// weights are 1
  std::optional<Conformality> collar_conformality(const Points& positions,
                                                  const Quaternion_vector<double>& lambda) const;

  /// the mesh with other positions of the part; all other vertices stay, to the bit
  Points in_whole(const Points& positions) const;

  /// the spins of the mesh, 1 outside of the part
  Quaternion_vector<double> in_whole(const Quaternion_vector<double>& lambda) const;

  /// numbers of the vertices of the mesh, 0 outside of the part
  Eigen::VectorXd in_whole(const Eigen::VectorXd& numbers) const;

 private:
  void choose_anchors();

  Points m_positions;  // of the mesh
  Mesh_component m_part;
  Eigen::VectorXd m_weights, m_shares;  // of the vertices of the part: w, s
  std::vector<int> m_in_part;           // the vertices of the mesh there; -1 outside
  std::vector<Control_point> m_anchors;
};

/// options of `Conformal_deformation`
struct Conformal_deformation_options {
  /// how handles stay closed, mollification, and the bound on scales; the boundary has to be free
  Spin_transformation_options surface = {};
  /// weight of the distances from the targets against rho, in multiples of 1 / R with R the radius
  /// of the sphere of the same area; infinity: the targets are met exactly
  double position_weight = std::numeric_limits<double>::infinity();
  /// for each vertex of the mesh its weight in the `Region_of_interest`; empty: all may move. Of
  /// several parts those with a control point move, see `weights_at()`
  Eigen::VectorXd region = {};
  double min_step = 1. / 32;  ///< the smallest step towards the targets, as a share of the way
};

/// \brief deforms a surface conformally so that control points on it move to given positions: finds
/// the least change rho of mean curvature, and spins that nearly solve its Dirac equation [CGP
/// (5.3)-(5.5)], whose surface, placed by a similarity, has them there.
///
/// These are those of `Relaxed_positions`: rho is the smallest in the norm of `Potential_metric`,
/// and so smooth. Similarities cost nothing: if the targets are the image of the control points
/// under one, so is the result. The targets are approached in steps along straight lines, after the
/// similarity, and a step counts only if the surface it leads to verifies and no face is flipped.
/// Where that fails, the result is the last surface that did, and `Spin_report::reached` its share
/// of the way.
///
/// Around handles and holes the edges of the surface stay closed, by a `Period_residual`. A
/// boundary is free. With a bound on scales, the weight of a term for them is raised until the
/// lengths are within it, relative to the result without the similarity; the way ends where that
/// fails.
///
/// With a region, only its faces are deformed, and those of the anchors of the `Region_of_interest`
/// are held near to where they are, as firmly as the targets can be reached with: the collar gives.
/// The result fades out in the collar; rho is that of the deformation before.
///
/// `Spin_report::limits` of the result demand that all of the way is made.
///
class Conformal_deformation {
 public:
  /// \throw as the constructor of `Spin_transformation` if there is no region, or
  /// `require_region()`; and Precondition_error if the boundary is not free, or the position weight
  /// not positive
  explicit Conformal_deformation(const Mesh_view& mesh,
                                 const Conformal_deformation_options& options = {},
                                 const std::string& function = "Conformal_deformation");
  ~Conformal_deformation();

  /// \brief deforms the surface that was given to the constructor.
  ///
  /// With the points of the last call, as while one is dragged, it starts from the last spins, with
  /// the factor found there as long as these move little: a small move takes a few solves. Targets
  /// that cannot be reached from there are approached from the initial surface. The sum of the
  /// terms is that of a first call up to about 2 %; where its minimum is flat, as on a round
  /// sphere, the positions differ by more.
  ///
  /// The report contains the share of the way (`reached`), the number of `steps`, and the distances
  /// from the targets (`position_error`). If it was cancelled, there are no positions.
  /// With other parts of the region than in the last call, it begins anew.
  /// \param points with targets in the unit of the mesh
  /// \throw as the constructor of `Spin_transformation`, for the region if there is one, and of
  /// `Region_of_interest`; Precondition_error see `require_control_points()`, or all targets are at
  /// one place though the points are not, or a point is not inside of the region, or `go_further`
  /// calls this function back
  /// \throw Solver_error if the first factorization fails
  Spin_result deform(const std::vector<Control_point>& points,
                     const Go_further& go_further = Always_go_further());

  /// the change of mean curvature found last, in 1/length of the mesh, one number per vertex
  const Curvature_potential& potential() const { return m_rho; }

  /// the weights of the region in the parts that moved last, |V|; empty without a region
  const Eigen::VectorXd& region() const { return m_weights; }

 private:
  struct Search;  // `Relaxed_positions`, and where they began

  /// how far control points have come
  struct Walk {
    double reached = 0;  // share of the way
    int steps = 0;
    bool is_cancelled = false;
    std::optional<Spin_result> result;  // where it ends, if that was looked at
  };

  void set_region(Eigen::VectorXd weights);

  /// \throw Precondition_error if the best similarity shrinks the points to one
  void require_extent(const std::vector<Control_point>& points) const;

  /// the points on the surface that is transformed, and what holds it
  std::vector<Control_point> all_points(const std::vector<Control_point>& points) const;

  std::size_t number_of_anchors() const { return m_region ? m_region->anchors().size() : 0; }

  /// goes from the present surface as far as surfaces are good, in steps along straight lines
  Walk walk(const std::vector<Control_point>& points, const Go_further& go_further);

  /// \brief goes on to the next surface, a share of the way
  /// \returns whether targets are met there, and it can be a result; otherwise all is as it was
  bool go_to(const std::vector<Control_point>& points, double share, Walk& walk,
             const Go_further& go_further);

  /// likewise from the last surface with the same points, or else from the initial one
  Walk search(const std::vector<Control_point>& points, const Go_further& go_further);

  /// the present surface after `place()`
  Spin_result present(const std::vector<Control_point>& points, double share) const;

  /// \brief moves a surface to the targets by a similarity, and measures distances there; with a
  /// region, to a share of the way to them, and fades it out
  void place(const std::vector<Control_point>& points, double share, Spin_result& result) const;

  std::string m_function;
  Visit_guard m_visits;
  Mesh_view m_mesh;
  Conformal_deformation_options m_given;
  Eigen::VectorXd m_weights;                   // of the region that moves; empty: the whole mesh
  std::optional<Region_of_interest> m_region;  // none: the whole mesh
  Conformal_deformation_options m_options;     // for what moves
  std::optional<Spin_transformation> m_transformation;
  std::unique_ptr<Search> m_positions;  // of the last points; refers to members before
  Curvature_potential m_rho;
};

}  // namespace Conformal_geometry_processing::internal
