// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing::internal {

/// \brief the surface of a spin transformation in a frame of unit size around its centre: a mesh,
/// or with mollification its intrinsic Delaunay triangulation.
class Framed_surface {
 public:
  /// \param mollification see `mollified_lengths()`; if empty, the surface is the mesh itself
  /// \pre `require()` holds
  Framed_surface(const Mesh_view& mesh, std::optional<double> mollification);

  Framed_surface(const Framed_surface&) = delete;
  Framed_surface& operator=(const Framed_surface&) = delete;

  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with finite
  /// coordinates and, without mollification, positive areas; or mollification is not in (0, 1)
  static void require(const Mesh_view& mesh, std::optional<double> mollification,
                      const std::string& function);

  /// \throw Precondition_error if a coordinate is not finite, or a face (with mollification: every
  /// face) has area zero
  static void require_faces(const Mesh_view& mesh, bool is_mollified, const std::string& function);

  /// \brief adopts new positions of the mesh; references to the surface stay valid.
  /// \pre there is no mollification; `require_faces()` holds
  void set_positions(const Points& positions);

  const Points& positions() const { return m_positions; }  ///< 3 x |V|, not in the frame
  const Normalized_frame& frame() const { return m_frame; }
  double unit() const { return m_frame.unit(); }
  const Mesh_view& mesh() const { return m_mesh; }  ///< in the frame
  Surface_ref surface() const;                      ///< in the frame

  /// the part of the mesh on which area, centroid and certificate are measured, in the frame: the
  /// whole mesh, or with mollification the `well_shaped_faces()`
  const Mesh_view& measured() const { return m_measured ? m_measured->mesh : m_mesh; }

  /// the condition with its positions in the frame; directions do not change
  Boundary_condition in_frame(Boundary_condition condition) const;

  /// `Prescribed_directions::errors()` of the surface with other positions, in the frame
  template <class Directions>
  Eigen::VectorXd direction_errors(const Directions& directions, const Points& positions,
                                   const Points& targets) const
  {
    const Mesh_view moved(positions, m_mesh.corners());
    return m_view ? directions.errors(Delaunay_view(moved, m_mollification), targets)
                  : directions.errors(moved, targets);
  }

  /// whether there are loops around handles or holes
  bool has_loops() const;

  /// \brief the `closed_generators()` of the mesh, transferred to the surface: edges x number of
  /// loops. O(edges) for each. Without mollification they are found anew, because they would take
  /// much memory.
  Eigen::MatrixXd forms() const;

  bool is_mollified() const { return m_view.has_value(); }
  Spin_report::Mollification mollification() const;

 private:
  Points m_positions;
  Normalized_frame m_frame;
  Mesh_view m_mesh;
  double m_mollification;
  std::optional<Delaunay_view> m_view;
  std::optional<Well_shaped_faces> m_measured;
};

}  // namespace Conformal_geometry_processing::internal
