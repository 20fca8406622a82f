// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Curvature_filter.h>
#include <Conformal_geometry_processing/flow/Flow_options.h>
#include <Conformal_geometry_processing/flow/Volume_constraint.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief the direction -H of the conformal Willmore flow [CGP 6.4.2]: the flow changes the
/// curvature itself, so every frequency is damped at the same rate.
///
/// H is computed with mixed Voronoi areas: icospheres are then fixed points to 1e-7, with
/// barycentric areas only to 1e-4.
struct Willmore_direction {
  /// the prescribed rate of change of H |df|, |V| numbers in 1/length
  Eigen::VectorXd operator()(const Surface_ref& surface) const { return -mean_curvature(surface); }

  /// the energy that the flow decreases
  double energy(const Surface_ref& surface) const { return willmore_energy(surface); }
};

namespace internal {

template <class Direction, class Surface, class = void>
constexpr bool has_energy_of = false;

template <class Direction, class Surface>
constexpr bool has_energy_of<Direction, Surface,
                             std::void_t<decltype(std::declval<const Direction&>().energy(
                                 std::declval<const Surface&>()))>> = true;

/// \brief A direction of a flow whose type is forgotten: that of the Willmore flow by default; any
/// model of `CurvatureDirection` converts to it.
class Curvature_direction_ref {
 public:
  Curvature_direction_ref() : Curvature_direction_ref(Willmore_direction()) {}

  /// \tparam Direction a model of `CurvatureDirection`; converts
  template <class Direction,
            class = std::enable_if_t<!std::is_same_v<Direction, Curvature_direction_ref>>>
  Curvature_direction_ref(Direction direction) : m_has_energy(has_energy_of<Direction, Mesh_view>)
  {
    const auto shared = std::make_shared<const Direction>(std::move(direction));
    m_rate = [shared](const Mesh_view& mesh, const Surface_ref& surface, double unit) {
      if constexpr (std::is_invocable_v<const Direction&, const Surface_ref&>)
        return Eigen::VectorXd((*shared)(surface) / unit);
      else
        return Eigen::VectorXd((*shared)(mesh));
    };
    m_energy = [shared](const Mesh_view& mesh, const Surface_ref& surface) -> double {
      if constexpr (has_energy_of<Direction, Surface_ref>)
        return shared->energy(surface);
      else if constexpr (has_energy_of<Direction, Mesh_view>)
        return shared->energy(mesh);
      else
        return willmore_energy(surface);
    };
  }

  /// \brief the direction on a mesh, in 1/length of it.
  /// \param surface the mesh, or a triangulation of it, with another unit of length
  Eigen::VectorXd rate(const Mesh_view& mesh, const Surface_ref& surface, double unit) const
  {
    return m_rate(mesh, surface, unit);
  }

  bool has_energy() const { return m_has_energy; }

  /// what decreases along the direction; without any, the Willmore energy
  double energy(const Mesh_view& mesh, const Surface_ref& surface) const
  {
    return m_energy(mesh, surface);
  }

 private:
  bool m_has_energy;
  std::function<Eigen::VectorXd(const Mesh_view&, const Surface_ref&, double)> m_rate;
  std::function<double(const Mesh_view&, const Surface_ref&)> m_energy;
};

/// \brief filters the direction of a flow and projects it onto the constraints [CGP 6.4.4].
///
/// Removes the constants, if they have no effect; the functions of `Exactness_constraints`; and on
/// closed surfaces the components of the normals, which correspond to sphere inversions: the
/// curvature has no component along them, but the filtered curvature has, and would make the
/// surface drift. With a `Volume_constraint`, which inversions do not keep, its gradient is removed
/// instead.
///
/// \tparam Direction a model of `CurvatureDirection`
class Constrained_direction {
 public:
  using Transformation = Spin_transformation;

  /// the direction on one surface
  struct Result {
    Eigen::VectorXd v;        ///< |V| numbers in 1/length
    double norm = 0;          ///< root of the integral of v^2
    double share = 0;         ///< remaining share of the direction, between 0 and 1
    Eigen::VectorXd filling;  ///< `Volume_constraint::Directions::filling`, |V| numbers in
                              ///< 1/length; zero without this constraint
    int factorizations = 0, solves = 0;  ///< that the volume has needed

    /// \brief whether a share of at most `tolerance` remains of the direction, or of the curvature
    /// of a round sphere: the direction of a flat surface is rounding error, all of which remains.
    bool has_vanished(double tolerance) const;
  };

  /// \param transformation of the evolving surface; must outlive the object
  /// \param volume null without this constraint; must outlive the object
  Constrained_direction(Transformation& transformation, Curvature_direction_ref direction,
                        const Flow_options& options, const Volume_constraint* volume,
                        std::string function);

  const Curvature_direction_ref& unconstrained() const { return m_direction; }

  /// \brief the direction on the present surface.
  /// \param mesh the surface
  /// \throw Precondition_error if the direction is not one finite number per vertex
  /// \throw Solver_error if a factorization or a solve fails, or the surface is so degenerate that
  /// its constraints are meaningless
  Result operator()(const Mesh_view& mesh);

  /// \brief what the constraints of the present surface leave of the direction on the next one, of
  /// the same connectivity: the root of its integral, as `Result::norm`.
  /// \pre the surface has no triangulation of its own
  /// \throw Precondition_error if the direction is not one finite number per vertex
  double norm_on(const Mesh_view& next);

  /// the component of a change of curvature that keeps the edges exact
  Eigen::VectorXd exact_part(const Eigen::VectorXd& rho);

 private:
  Result constrained(const Eigen::VectorXd& raw);
  Result at_volume(const Constraint_basis& others, const Eigen::VectorXd& raw);
  Result measured(const Constraint_basis& all, Eigen::VectorXd v, const Eigen::VectorXd& raw) const;
  const Exactness_constraints& exactness();
  Eigen::VectorXd filtered(const Eigen::VectorXd& v);
  void require_one_per_vertex(const Eigen::VectorXd& v) const;

  Transformation& m_transformation;
  Curvature_direction_ref m_direction;
  const Volume_constraint* m_volume;
  double m_filter_weight;
  int m_filter_order;
  std::optional<Curvature_filter> m_filter;
  std::string m_function;
};

}  // namespace internal

}  // namespace Conformal_geometry_processing
