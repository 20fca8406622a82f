// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
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

}  // namespace internal
}  // namespace Conformal_geometry_processing
