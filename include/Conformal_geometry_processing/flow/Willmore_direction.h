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
/// \brief the direction -H of the conformal Willmore flow [CGP 6.4.2]: curvature itself is what
/// changes, so every frequency is damped at the same rate.
///
/// H has mixed Voronoi areas: with those the icospheres are fixed points to 1e-7, with barycentric
/// ones to 1e-4.
struct Willmore_direction {
  /// the wanted rate of change of H |df|, |V| numbers in 1/length
  Eigen::VectorXd operator()(const Surface_ref& surface) const { return -mean_curvature(surface); }

  /// what the flow decreases
  double energy(const Surface_ref& surface) const { return willmore_energy(surface); }
};

namespace internal {

template <class Direction, class = void>
struct Has_energy : std::false_type {};

template <class Direction>
struct Has_energy<Direction, std::void_t<decltype(std::declval<const Direction&>().energy(
                                 std::declval<const Mesh_view&>()))>> : std::true_type {};

/// whether a direction is one of any surface, not only of meshes
template <class Direction>
inline constexpr bool is_for_surfaces = std::is_invocable_v<const Direction&, const Surface_ref&>;

/// \brief the direction of a mesh, or of the surface that stands for it where the direction can be
/// taken there.
/// \param unit by which lengths of the mesh are larger than those of the surface
template <class Direction>
Eigen::VectorXd direction_of(const Direction& direction, const Mesh_view& mesh,
                             const Surface_ref& surface, double unit)
{
  if constexpr (is_for_surfaces<Direction>)
    return direction(surface) / unit;
  else
    return direction(mesh);
}

/// the energy of the direction, Willmore's if it has none, of a surface
template <class Direction>
double energy_of(const Direction& direction, const Mesh_view& mesh, const Surface_ref& surface)
{
  if constexpr (Has_energy<Direction>::value && is_for_surfaces<Direction>)
    return direction.energy(surface);
  else if constexpr (Has_energy<Direction>::value)
    return direction.energy(mesh);
  else
    return willmore_energy(surface);
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
