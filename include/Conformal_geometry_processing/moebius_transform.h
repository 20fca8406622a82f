// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/write_points.h>
#include <Quaternionic_linear_algebra/algebra/Moebius_map.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Scaling of the surface by a Moebius map: lengths at a vertex change by |lambda|^2.
struct Moebius_report {
  double min_length_scale = 0;
  double max_length_scale = 0;
};

/// Applies p -> map(p - center) + center. The center is not included in the map, because a distant
/// one would cost digits.
template <class TriangleMesh, class NamedParameters>
Moebius_report apply_around(const Eigen::Vector3d& center, const Moebius_map& map,
                            TriangleMesh& mesh, const NamedParameters& np,
                            const std::string& function)
{
  static_assert(
      only_known_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                            CGAL::internal_np::geom_traits_t,
                            internal_np::output_vertex_point_map_t, internal_np::vertex_spin_map_t>,
      "moebius_transform(), invert_in_sphere(): unknown named parameter");
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  const Points around = graph.view().positions().colwise() - center;
  const Quaternion_vector<double> lambda = map.spins(around, function);
  const Points image = map.transform(around, function).colwise() + center;
  write_spins(graph, lambda, np);
  write_points(mesh, graph, image, np);
  if (lambda.size() == 0) return {};
  const auto scales = components(lambda).colwise().squaredNorm();
  return {scales.minCoeff(), scales.maxCoeff()};
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief Applies a Moebius map of space to every vertex of a surface.
///
/// Conformal up to rounding: length cross-ratios are preserved. Triangles remain flat, so on coarse
/// meshes the surface only approximates the image. Its orientation is preserved; a surface that
/// encloses the point that is mapped to infinity is turned inside out, and its normals then point
/// inward. O(|V|), in double precision for any kernel.
///
/// \tparam TriangleMesh a triangle mesh, see \ref triangle_mesh_requirements
/// \param mesh may have a boundary; its points are overwritten
/// \param map in the coordinates of the mesh
/// \param np optional, as follows
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map, output_vertex_point_map, geom_traits}
///     \cgalParamDescription{see `spin_transform()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_spin_map}
///     \cgalParamDescription{receives lambda, with df~ = conjugate(lambda) df lambda}
///     \cgalParamType{a model of `WritablePropertyMap` whose value type is supported by
///                    `Quaternion_access`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \throw Precondition_error if a face is not a triangle, or a vertex is not finite or is mapped to
/// infinity; the message contains its index, and nothing is written
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
internal::Moebius_report moebius_transform(TriangleMesh& mesh, const Moebius_map& map,
                                           const NamedParameters& np = parameters::default_values())
{
  return internal::apply_around(Eigen::Vector3d::Zero(), map, mesh, np, "moebius_transform");
}

/// \ingroup PkgEntryPoints
/// \brief Inverts a surface in a sphere: p -> center - radius^2 (p - center) / |p - center|^2.
///
/// Composed with the reflection in the center, hence the sign, which preserves the orientation of
/// the surface. For details see `moebius_transform()`.
///
/// \tparam TriangleMesh a triangle mesh, see \ref triangle_mesh_requirements
/// \tparam Point the type of the points of the mesh
/// \param mesh may have a boundary; its points are overwritten
/// \param center not on a vertex
/// \param radius positive
/// \param np optional, as for `moebius_transform()`
/// \throw Precondition_error likewise, or if the center is not finite or the radius not positive
template <class TriangleMesh, class Point,
          class NamedParameters = parameters::Default_named_parameters>
internal::Moebius_report invert_in_sphere(TriangleMesh& mesh, const Point& center, double radius,
                                          const NamedParameters& np = parameters::default_values())
{
  const Eigen::Vector3d c =
      internal::coordinates_of(center, internal::geometry_traits<TriangleMesh>(np));
  if (!(radius > 0) || !std::isfinite(radius) || !c.allFinite())
    throw Precondition_error("invert_in_sphere", "the center must be finite, and the radius, " +
                                                     std::to_string(radius) + ", positive");
  const Moebius_map inversion =
      Moebius_map::scaling(radius) * Moebius_map::inversion() * Moebius_map::scaling(1 / radius);
  return internal::apply_around(c, inversion, mesh, np, "invert_in_sphere");
}

}  // namespace Conformal_geometry_processing
