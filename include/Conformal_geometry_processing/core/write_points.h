// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// Writes the positions, 3 x |V|, to the output given by named parameters. If a map throws, the
/// points are restored, unless they are written to a separate output map.
template <class TriangleMesh, class NamedParameters>
void write_points(TriangleMesh& mesh, const Graph_view<TriangleMesh>& graph,
                  const Points& positions, const NamedParameters& np)
{
  const auto points = output_vertex_points(mesh, np);
  const auto traits = geometry_traits<TriangleMesh>(np);
  if constexpr (has_parameter<NamedParameters, internal_np::output_vertex_point_map_t>) {
    graph.write_positions(positions, points, traits);
  } else {
    std::vector<typename boost::property_traits<std::decay_t<decltype(points)>>::value_type> old;
    for (int v = 0; v < graph.view().size_of_vertices(); ++v)
      old.push_back(get(points, graph.vertex(v)));
    try {
      graph.write_positions(positions, points, traits);
    } catch (...) {
      for (int v = 0; v < graph.view().size_of_vertices(); ++v)
        put(points, graph.vertex(v), old[static_cast<std::size_t>(v)]);
      throw;
    }
  }
}

// w(), ..., z() and vec(): Eigen::Quaternion, but not Eigen::Vector4d, whose w() is the last entry.
template <class Q>
auto components_of(const Q& q) -> decltype(q.vec(), std::array{q.w(), q.x(), q.y(), q.z()})
{
  return {q.w(), q.x(), q.y(), q.z()};
}

// R_component_1() ... R_component_4(): boost::math::quaternion.
template <class Q>
auto components_of(const Q& q) -> std::array<decltype(q.R_component_4()), 4>
{
  return {q.R_component_1(), q.R_component_2(), q.R_component_3(), q.R_component_4()};
}

// [0] ... [3]: std::array, C++ aggregates, vectors of four.
template <class Q>
auto components_of(const Q& q) -> decltype(std::array{q[0], q[1], q[2], q[3]})
{
  return {q[0], q[1], q[2], q[3]};
}

template <class FT>
constexpr std::array<FT, 4> components_of(const Quaternion<FT>& q)
{
  return {q.w, q.x, q.y, q.z};
}

template <class Q, class = void>
inline constexpr bool has_subscripts = false;
template <class Q>
inline constexpr bool has_subscripts<Q, std::void_t<decltype(std::declval<Q&>()[0] = 0)>> = true;

}  // namespace internal

/// \ingroup PkgAlgebra
/// \brief Converts quaternion types of the user: `from(const Q&)` returns a `Quaternion<double>`,
/// `to(const Quaternion<double>&)` a `Q`.
///
/// Supports `Quaternion`, `Eigen::Quaternion`, `boost::math::quaternion`, and all types with
/// `[0] ... [3]` = w, x, y, z such as `std::array<double, 4>`. Specialize it for other types.
template <class Q>
struct Quaternion_access {
  using FT = typename decltype(internal::components_of(std::declval<const Q&>()))::value_type;

  static constexpr Quaternion<double> from(const Q& q)
  {
    const auto c = internal::components_of(q);
    return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2]),
            static_cast<double>(c[3])};
  }

  static constexpr Q to(const Quaternion<double>& q)
  {
    const std::array c{static_cast<FT>(q.w), static_cast<FT>(q.x), static_cast<FT>(q.y),
                       static_cast<FT>(q.z)};
    if constexpr (internal::has_subscripts<Q>) {
      Q result{};
      result[0] = c[0], result[1] = c[1], result[2] = c[2], result[3] = c[3];
      return result;
    } else if constexpr (std::is_same_v<Q, Quaternion<FT>>) {
      return {c[0], c[1], c[2], c[3]};
    } else {
      return Q(c[0], c[1], c[2], c[3]);
    }
  }
};

namespace internal {

/// Writes lambda, if named parameters have a map for it
template <class TriangleMesh, class NamedParameters>
void write_spins(const Graph_view<TriangleMesh>& graph, const Quaternion_vector<double>& lambda,
                 const NamedParameters& np)
{
  if constexpr (has_parameter<NamedParameters, internal_np::vertex_spin_map_t>) {
    auto spins = CGAL::parameters::get_parameter(np, internal_np::vertex_spin_map);
    using Value = typename boost::property_traits<decltype(spins)>::value_type;
    for (int v = 0; v < graph.view().size_of_vertices(); ++v)
      put(spins, graph.vertex(v), Quaternion_access<Value>::to(lambda[v]));
  }
}

}  // namespace internal
}  // namespace Conformal_geometry_processing
