// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/curves/Isometric_curve_flow.h>
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

namespace Conformal_geometry_processing {
namespace internal {

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

template <class NamedParameters>
Curve_flow_options curve_flow_options(const NamedParameters& np)
{
  Curve_flow_options o;
  read_parameter(np, internal_np::is_closed, o.is_closed);
  read_parameter(np, internal_np::time_step, o.time_step);
  read_parameter(np, CGAL::internal_np::number_of_iterations, o.max_steps);
  read_parameter(np, internal_np::tolerance, o.energy_tolerance);
  return o;
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief Smooths a curve in the plane as far as its turning number allows, in a few large steps
/// that preserve the length of every edge [CGP 4.2, 6.4.3].
///
/// The curve is a polygon, closed or open. Closed curves of turning number k converge to k-fold
/// circles, or for k = 0 to the figure eight of minimal bending energy, also from figure eights
/// that are run through several times, which are saddles; open ones converge to straight lines. The
/// energy, the integral of the squared curvature, decreases in every step; a step that would raise
/// it is repeated with half of tau. The centroid is fixed.
///
/// Computes in double precision for any kernel. O(m) for each step, without a factorization. Use
/// `Isometric_curve_flow` for single steps.
///
/// \tparam PointRange a model of `Range` with mutable iterators over keys of the point map
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param points the vertices in order, at least three; they are overwritten
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{is_closed}
///     \cgalParamDescription{whether the last point is followed by the first}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{time_step}
///     \cgalParamDescription{tau, between 0 and 1: a step multiplies the removable part of the
///                           curvature by 1 - 2 tau, so 1/2 converges fastest and small values
///                           show the evolution}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0.5}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{maximal number of steps}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{the flow stops if the relative change of the energy per unit of time
///                           is below it}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-8}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is called for every step and may stop the flow}
///     \cgalParamType{a `std::reference_wrapper` of a model of `CurveFlowVisitor`}
///     \cgalParamDefault{`Curve_flow_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{point_map}
///     \cgalParamDescription{the point of each element of the range; read and written}
///     \cgalParamType{a model of `ReadWritePropertyMap` with the value type of the range as key}
///     \cgalParamDefault{`CGAL::Identity_property_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamType{a model of `ConformalGeometryTraits_2`}
///     \cgalParamDefault{the kernel of the points}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report, which contains the reason why the flow has stopped, and converts to `true`
/// if it has converged or has done the requested steps. In any case, the points are those of the
/// last complete step.
/// \throw Precondition_error if there are fewer than three points, one has a coordinate that is not
/// finite, two consecutive ones coincide, the curve reverses its direction at a point, or a
/// parameter is out of its range; the message names the point. If an exception is thrown, also by
/// the visitor, the points are unchanged.
template <class PointRange, class NamedParameters = parameters::Default_named_parameters>
Curve_flow_report isometric_curve_flow(PointRange& points,
                                       const NamedParameters& np = parameters::default_values())
{
  static_assert(
      internal::only_known_parameters<
          NamedParameters, CGAL::internal_np::point_t, CGAL::internal_np::geom_traits_t,
          CGAL::internal_np::number_of_iterations_t, CGAL::internal_np::visitor_t,
          internal_np::is_closed_t, internal_np::time_step_t, internal_np::tolerance_t>,
      "isometric_curve_flow(): unknown named parameter, see the manual for those it accepts");
  Curve_flow_visitor silent;
  auto&& visitor = internal::parameter_or(np, CGAL::internal_np::visitor, silent);
  Isometric_curve_flow flow(internal::read_points(points, np), internal::curve_flow_options(np),
                            "isometric_curve_flow");
  Curve_flow_report report = flow.run(visitor);
  internal::write_points(points, flow.points(), np);
  return report;
}

}  // namespace Conformal_geometry_processing
