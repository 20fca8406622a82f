// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/point_ranges.h>
#include <Conformal_geometry_processing/curves/Isometric_curve_flow.h>

namespace Conformal_geometry_processing {
namespace internal {

template <class NamedParameters>
Curve_flow_options curve_flow_options(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Curve_flow_options o;
  o.is_closed = choose_parameter(get_parameter(np, internal_np::is_closed), o.is_closed);
  o.time_step = choose_parameter(get_parameter(np, internal_np::time_step), o.time_step);
  o.max_steps = static_cast<int>(
      choose_parameter(get_parameter(np, CGAL::internal_np::number_of_iterations), o.max_steps));
  o.energy_tolerance =
      choose_parameter(get_parameter(np, internal_np::tolerance), o.energy_tolerance);
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
