// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/curves/polygons.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <Eigen/Core>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

template <class GeomTraits, class = void>
struct Is_planar_geometry_traits : std::false_type {};

template <class T>
struct Is_planar_geometry_traits<
    T, std::void_t<decltype(CGAL::to_double(std::declval<const T&>().compute_x_2_object()(
                       std::declval<const typename T::Point_2&>()))),
                   decltype(CGAL::to_double(std::declval<const T&>().compute_y_2_object()(
                       std::declval<const typename T::Point_2&>()))),
                   decltype(typename T::Point_2(std::declval<const T&>().construct_point_2_object()(
                       typename T::FT(0.), typename T::FT(0.))))>> : std::true_type {};

/// Returns the point map of a range: `point_map`, by default the elements themselves
template <class PointRange, class NamedParameters>
auto point_map_of(const PointRange& points, const NamedParameters& np)
{
  if constexpr (has_parameter<NamedParameters, CGAL::internal_np::point_t>)
    return CGAL::parameters::get_parameter(np, CGAL::internal_np::point_map);
  else
    return CGAL::Identity_property_map<std::decay_t<decltype(*std::begin(points))>>();
}

/// Returns the `geom_traits` of a pack, or else the kernel of the points
template <class Point, class NamedParameters>
auto planar_geometry_traits(const NamedParameters& np)
{
  if constexpr (has_parameter<NamedParameters, CGAL::internal_np::geom_traits_t>) {
    return CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits);
  } else {
    using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
    static_assert(Is_planar_geometry_traits<Kernel>::value,
                  "the points of the curve belong to no kernel: pass geom_traits()");
    return Kernel();
  }
}

template <class PointRange, class NamedParameters>
using Planar_point = typename boost::property_traits<decltype(point_map_of(
    std::declval<const PointRange&>(), std::declval<const NamedParameters&>()))>::value_type;

/// Reads the points of a range, 2 x m
template <class PointRange, class NamedParameters>
Plane_points read_points(const PointRange& points, const NamedParameters& np)
{
  const auto map = point_map_of(points, np);
  const auto traits = planar_geometry_traits<Planar_point<PointRange, NamedParameters>>(np);
  const auto x = traits.compute_x_2_object();
  const auto y = traits.compute_y_2_object();
  Plane_points result(2, static_cast<Eigen::Index>(std::distance(points.begin(), points.end())));
  Eigen::Index i = 0;
  for (const auto& element : points) {
    const auto& point = get(map, element);
    result.col(i++) = Eigen::Vector2d(CGAL::to_double(x(point)), CGAL::to_double(y(point)));
  }
  return result;
}

/// Writes m points to a range of the same size. If a map throws, the range is unchanged.
template <class PointRange, class NamedParameters>
void write_points(PointRange& points, const Plane_points& positions, const NamedParameters& np)
{
  using Point = Planar_point<PointRange, NamedParameters>;
  const auto map = point_map_of(points, np);
  const auto traits = planar_geometry_traits<Point>(np);
  using FT = typename std::decay_t<decltype(traits)>::FT;
  const auto construct = traits.construct_point_2_object();
  std::vector<Point> old;
  for (const auto& element : points) old.push_back(get(map, element));
  try {
    Eigen::Index i = 0;
    for (auto& element : points) {
      put(map, element, construct(FT(positions(0, i)), FT(positions(1, i))));
      ++i;
    }
  } catch (...) {
    auto point = old.begin();
    for (auto& element : points) put(map, element, *point++);
    throw;
  }
}

}  // namespace Conformal_geometry_processing::internal
