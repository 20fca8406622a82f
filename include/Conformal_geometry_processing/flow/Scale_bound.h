// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace Conformal_geometry_processing::internal {

/// \brief the logarithms of the factors by which lengths have changed, |V|: u of the vertices of a
/// face with lengths exp((u_i + u_j) / 2) times those before, in the mean over the faces of a
/// vertex. On the exact conformal class, all its faces agree.
Eigen::VectorXd vertex_log_scales(const Mesh_view& before, const Points& after);

/// \brief the bound on lengths in a flow, against its initial surface, weighted by the areas there:
/// by those of the present surface, what has collapsed would not count.
class Scale_bound {
 public:
  /// \param bound > 1
  Scale_bound(const Mesh_view& initial, double bound);

  /// of a surface of the same connectivity
  Spin_report::Scales measured(const Points& positions) const;

  /// \brief what a transformation of a surface has to keep to: from where its lengths are, the rest
  /// of the bound less `retreat`, in units of `excess()`.
  Scale_control control(const Mesh_view& surface, double retreat) const;

  /// what steps have learned from those before them, for a time of 1
  struct Pace {
    double weight = .03;  ///< where the search for that of scales begins
    /// by how much lengths have to stay below the bound, for what the edges leave open and the way
    /// back to the class move them, too
    double retreat = 0;
  };
  const Pace& pace() const { return m_pace; }
  void set_pace(const Pace& pace) { m_pace = pace; }

  /// \brief the surface of spins and a rho' that is as near to rho as the bound, handles and holes
  /// allow, see `Relaxed_scales`. It tends to the present one with rho and `time`. None if that
  /// rho' opposes rho: along it the energy rises.
  /// \param rho |V|, in 1/length of the mesh
  /// \param time tau by the largest one
  /// \throw Solver_error if a factorization fails
  std::optional<Spin_result> step(
      Spin_transformation& transformation, const Mesh_view& surface, const Eigen::VectorXd& rho,
      double time, const std::function<bool(const Eigensolver_progress&)>& go_further);

  /// takes up how far the lengths of a step were from the bound in the end
  void learn(const Points& positions, double time);

 private:
  static Relaxed_scales_options options(double time);
  bool find(Relaxed_scales& search, const Eigen::VectorXd& rho, double time,
            const std::function<bool(const Eigensolver_progress&)>& go_further);

  Mesh_view m_initial;
  Eigen::VectorXd m_areas;
  Scale_control m_control;
  Pace m_pace;
};

}  // namespace Conformal_geometry_processing::internal
