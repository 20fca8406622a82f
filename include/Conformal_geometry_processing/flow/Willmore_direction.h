// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_WILLMORE_DIRECTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_WILLMORE_DIRECTION_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <Eigen/Core>

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

template <class Direction, class Surface = Mesh_view, class = void>
struct Has_energy : std::false_type {};

template <class Direction, class Surface>
struct Has_energy<
    Direction, Surface,
    std::void_t<decltype(std::declval<const Direction&>().energy(std::declval<const Surface&>()))>>
    : std::true_type {};

/// whether a direction is defined on any surface, not only on meshes
template <class Direction>
inline constexpr bool is_for_surfaces = std::is_invocable_v<const Direction&, const Surface_ref&>;

/// \brief the direction on the surface if it is defined there, otherwise on the mesh.
/// \param unit ratio of lengths of the mesh to lengths of the surface
template <class Direction>
Eigen::VectorXd direction_of(const Direction& direction, const Mesh_view& mesh,
                             const Surface_ref& surface, double unit)
{
  if constexpr (is_for_surfaces<Direction>)
    return direction(surface) / unit;
  else
    return direction(mesh);
}

/// the energy of the direction on a surface; Willmore energy if it has none
template <class Direction>
double energy_of(const Direction& direction, const Mesh_view& mesh, const Surface_ref& surface)
{
  if constexpr (Has_energy<Direction, Surface_ref>::value)
    return direction.energy(surface);
  else if constexpr (Has_energy<Direction>::value)
    return direction.energy(mesh);
  else
    return willmore_energy(surface);
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
