// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_POSITION_RESIDUAL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_POSITION_RESIDUAL_H

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Control_point.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgSpin
/// \brief the best similarity from points to targets, both in a frame of unit size: of those that
/// fit equally well (one point, two, a line of them), that which turns and scales least.
Alignment placement(const Points& points, const Points& targets);

/// \ingroup PkgSpin
/// \brief what similarities cannot change: an orthonormal basis of the motions of points that are
/// orthogonal to translations, turns and scaling, 3k x (3k - 7), with more columns if the points
/// are on a line.
/// \param points 3 x k \param columns of the result
Eigen::MatrixXd shape_motions(const Points& points, Eigen::Index columns);

/// 3k less the dimension of the motions of k points by similarities
Eigen::Index number_of_shape_motions(const Points& points);

/// \ingroup PkgSpin
/// \brief the distances of control points of a transformed surface from their targets, after the
/// best similarity T, in the frame of the surface.
///
/// The values are Z^T (T h - t) with h the control points and Z the `shape_motions()` of T h. The
/// change of T is orthogonal to Z, so the change of the values is Z^T dT(dh), up to the change of
/// Z, which is multiplied by distances that become zero. The similarity may be anything: the total
/// scale, the position, and the turn of the surface have no effect.
template <class SolverTraits>
class Position_residual : public Spin_residual {
 public:
  /// \param surface, reconstruction must outlive the object
  Position_residual(const Surface_ref& surface,
                    const Poisson_reconstruction<SolverTraits>& reconstruction,
                    std::vector<Control_point> points);

  /// \param targets 3 x number of points, in the frame
  void set_targets(Points targets);

  /// \param w the values are multiplied by its root
  void set_weight(double w) { m_weight = w; }

  void set_spins(const Spins& lambda) override;
  Eigen::VectorXd values() const override;
  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;

 private:
  Surface_ref m_surface;
  const Poisson_reconstruction<SolverTraits>& m_reconstruction;
  std::vector<Control_point> m_points;
  Points m_targets;
  double m_weight = 1;
  Spins m_lambda;
  Alignment m_placement;      // T
  Points m_distances;         // T h - t
  Eigen::MatrixXd m_motions;  // Z
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Position_residual_impl.h>
#include <Conformal_geometry_processing/spin/Position_residual_templates.h>
#endif

#endif
