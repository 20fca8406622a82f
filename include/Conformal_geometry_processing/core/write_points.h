// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>

#include <boost/property_map/property_map.hpp>

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

// std::void_t does not distinguish partial specializations in clang before 15 (CWG 1980).
template <class...>
struct Make_void {
  using type = void;
};

// w(), ..., z() and vec(): Eigen::Quaternion, but not Eigen::Vector4d, whose w() is the last entry.
template <class Q>
using Has_named_components = typename Make_void<decltype(std::declval<const Q&>().w()),
                                                decltype(std::declval<const Q&>().vec())>::type;

// R_component_1() ... R_component_4(): boost::math::quaternion.
template <class Q>
using Has_numbered_components =
    typename Make_void<decltype(std::declval<const Q&>().R_component_1()),
                       decltype(std::declval<const Q&>().R_component_4())>::type;

// [0] ... [3]: std::array, C++ aggregates, vectors of four.
template <class Q>
using Has_subscripts = typename Make_void<decltype(std::declval<Q&>()[0] = 0)>::type;

template <class Q, class = void>
struct Default_quaternion_access {
  static_assert(!std::is_same_v<Q, Q>,
                "Specialize Conformal_geometry_processing::Quaternion_access for this type.");
};

template <class Q>
struct Default_quaternion_access<Q, Has_named_components<Q>> {
  using FT = std::decay_t<decltype(std::declval<const Q&>().w())>;
  static Quaternion<double> from(const Q& q)
  {
    return {static_cast<double>(q.w()), static_cast<double>(q.x()), static_cast<double>(q.y()),
            static_cast<double>(q.z())};
  }
  static Q to(const Quaternion<double>& q)
  {
    return Q(static_cast<FT>(q.w), static_cast<FT>(q.x), static_cast<FT>(q.y),
             static_cast<FT>(q.z));
  }
};

template <class Q>
struct Default_quaternion_access<Q, Has_numbered_components<Q>> {
  using FT = std::decay_t<decltype(std::declval<const Q&>().R_component_1())>;
  static Quaternion<double> from(const Q& q)
  {
    return {static_cast<double>(q.R_component_1()), static_cast<double>(q.R_component_2()),
            static_cast<double>(q.R_component_3()), static_cast<double>(q.R_component_4())};
  }
  static Q to(const Quaternion<double>& q)
  {
    return Q(static_cast<FT>(q.w), static_cast<FT>(q.x), static_cast<FT>(q.y),
             static_cast<FT>(q.z));
  }
};

template <class Q>
struct Default_quaternion_access<Q, Has_subscripts<Q>> {
  using FT = std::decay_t<decltype(std::declval<Q&>()[0])>;
  static Quaternion<double> from(const Q& q)
  {
    return {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2]),
            static_cast<double>(q[3])};
  }
  static Q to(const Quaternion<double>& q)
  {
    Q result{};
    result[0] = static_cast<FT>(q.w);
    result[1] = static_cast<FT>(q.x);
    result[2] = static_cast<FT>(q.y);
    result[3] = static_cast<FT>(q.z);
    return result;
  }
};

}  // namespace internal

/// \ingroup PkgAlgebra
/// \brief Converts quaternion types of the user: `from(const Q&)` returns a `Quaternion<double>`,
/// `to(const Quaternion<double>&)` a `Q`.
///
/// Supports `Quaternion`, `Eigen::Quaternion`, `boost::math::quaternion`, and all types with
/// `[0] ... [3]` = w, x, y, z such as `std::array<double, 4>`. Specialize it for other types.
template <class Q>
struct Quaternion_access : internal::Default_quaternion_access<Q> {};

template <class FT_>
struct Quaternion_access<Quaternion<FT_>> {
  using FT = FT_;
  static constexpr Quaternion<double> from(const Quaternion<FT>& q)
  {
    return {static_cast<double>(q.w), static_cast<double>(q.x), static_cast<double>(q.y),
            static_cast<double>(q.z)};
  }
  static constexpr Quaternion<FT> to(const Quaternion<double>& q)
  {
    return {static_cast<FT>(q.w), static_cast<FT>(q.x), static_cast<FT>(q.y), static_cast<FT>(q.z)};
  }
};

}  // namespace Conformal_geometry_processing
