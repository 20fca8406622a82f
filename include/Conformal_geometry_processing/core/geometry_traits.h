// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/named_parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing::internal {

template <class GeomTraits, class = void>
struct Is_conformal_geometry_traits : std::false_type {};

template <class T>
using Coordinate = decltype(CGAL::to_double(std::declval<T>()));

template <class T>
struct Is_conformal_geometry_traits<
    T, std::void_t<typename T::FT, typename T::Point_3,
                   Coordinate<decltype(std::declval<const T&>().compute_x_3_object()(
                       std::declval<const typename T::Point_3&>()))>,
                   Coordinate<decltype(std::declval<const T&>().compute_y_3_object()(
                       std::declval<const typename T::Point_3&>()))>,
                   Coordinate<decltype(std::declval<const T&>().compute_z_3_object()(
                       std::declval<const typename T::Point_3&>()))>,
                   decltype(typename T::Point_3(std::declval<const T&>().construct_point_3_object()(
                       typename T::FT(0.), typename T::FT(0.), typename T::FT(0.))))>>
    : std::true_type {};

/// Whether a type is a model of `ConformalGeometryTraits_3`
template <class GeomTraits>
inline constexpr bool is_conformal_geometry_traits =
    Is_conformal_geometry_traits<GeomTraits>::value;

/// The coordinates of a point, from the traits
template <class Point, class GeomTraits>
Eigen::Vector3d coordinates_of(const Point& p, const GeomTraits& traits)
{
  return {CGAL::to_double(traits.compute_x_3_object()(p)),
          CGAL::to_double(traits.compute_y_3_object()(p)),
          CGAL::to_double(traits.compute_z_3_object()(p))};
}

/// Returns a readable map of the points of the vertices
template <class TriangleMesh, class NamedParameters>
auto vertex_points(const TriangleMesh& mesh, const NamedParameters& np)
{
  if constexpr (has_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>)
    return CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point);
  else
    return CGAL::get_const_property_map(CGAL::vertex_point, mesh);
}

/// The type of these points. Uses the point map of the mesh only if the pack has none, because the
/// mesh may have none
template <class TriangleMesh, class NamedParameters>
using Point_of = typename boost::property_traits<decltype(vertex_points(
    std::declval<const TriangleMesh&>(), std::declval<const NamedParameters&>()))>::value_type;

/// Returns the `geom_traits` of a pack, or else the kernel of the points. The latter is determined
/// only if necessary: `CGAL::GetGeomTraits` does not compile for points without a kernel even if
/// the pack contains traits.
template <class TriangleMesh, class NamedParameters>
auto geometry_traits(const NamedParameters& np)
{
  if constexpr (has_parameter<NamedParameters, CGAL::internal_np::geom_traits_t>) {
    return CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits);
  } else {
    using Kernel = typename CGAL::Kernel_traits<Point_of<TriangleMesh, NamedParameters>>::Kernel;
    static_assert(is_conformal_geometry_traits<Kernel>,
                  "the points of the mesh belong to no kernel: pass geom_traits()");
    return Kernel();
  }
}

/// Returns the map for transformed points: `output_vertex_point_map`, by default in place
template <class TriangleMesh, class NamedParameters>
auto output_vertex_points(TriangleMesh& mesh, const NamedParameters& np)
{
  if constexpr (has_parameter<NamedParameters, internal_np::output_vertex_point_map_t>)
    return CGAL::parameters::get_parameter(np, internal_np::output_vertex_point_map);
  else if constexpr (has_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>)
    return CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point);
  else
    return CGAL::get_property_map(CGAL::vertex_point, mesh);
}

template <class Point, class = void>
struct Vector_of_point {
  using type = Eigen::Vector3d;
};

template <class Point>
struct Vector_of_point<Point, std::void_t<typename CGAL::Kernel_traits<Point>::Kernel::Vector_3>> {
  using type = typename CGAL::Kernel_traits<Point>::Kernel::Vector_3;
};

/// The vector type of the kernel of a point type, Eigen's if there is none
template <class Point>
using Vector_of = typename Vector_of_point<Point>::type;

}  // namespace Conformal_geometry_processing::internal
