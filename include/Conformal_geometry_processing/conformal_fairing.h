// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/write_points.h>
#include <Conformal_geometry_processing/flow/Flow_report.h>
#include <Conformal_geometry_processing/flow/fair_region.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// for each face of the view, whether it is in the range
template <class TriangleMesh, class FaceRange>
std::vector<char> read_region(const Graph_view<TriangleMesh>& graph, const FaceRange& region,
                              const std::string& function)
{
  std::unordered_set<typename Graph_view<TriangleMesh>::face_descriptor> faces;
  for (const auto& f : region) faces.insert(f);
  std::vector<char> is_in_region;
  for (int f = 0; f < graph.view().size_of_faces(); ++f)
    is_in_region.push_back(faces.erase(graph.face(f)) > 0);
  if (!faces.empty())
    throw Precondition_error(function,
                             counted(static_cast<int>(faces.size()), "#face") +
                                 " of the region not in the mesh; wanted: faces of the mesh");
  return is_in_region;
}

template <class NamedParameters>
Fairing_options fairing_options(const NamedParameters& np, const std::string& function)
{
  Fairing_options options;
  read_parameter(np, internal_np::exact_conformal_class, options.exact_conformal_class);
  read_parameter(np, CGAL::internal_np::number_of_iterations, options.max_steps);
  read_parameter(np, internal_np::tolerance, options.tolerance);
  if (!(options.tolerance > 0)) throw Precondition_error(function, "the tolerance is not positive");
  return options;
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief replaces a region of a surface by the smoothest one that meets its surroundings with the
/// same positions and normals.
///
/// Minimizes the Willmore energy of the region, the integral of H^2 [CGP 6.4], with vertices and
/// normals at the rim as they are: spheres are continued by spheres. By default among all surfaces
/// in the discrete conformal class of the region, that is, with its length cross-ratios: angles and
/// textures stay. With `exact_conformal_class(false)`, among all surfaces with that rim, for
/// regions that are not worth keeping, such as a hole just filled by
/// `CGAL::Polygon_mesh_processing::triangulate_and_refine_hole()`. Triangles then follow a harmonic
/// map from the region as it was.
///
/// Vertices move if all faces around them are in the region. All others keep their coordinates,
/// bitwise. Where the region touches the boundary of the mesh, the first row of faces is held, for
/// it carries the normals. Any genus, any number of rims; each component of the region needs one.
///
/// Every step lowers the energy, and factors a real matrix on the vertices that move; within the
/// class, one with blocks of 4 x 4 numbers. Where surfaces are nearly isothermic, as spheres are,
/// the steps within the class are short, and many.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam FaceRange a range of face descriptors, in any order
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the surface; the points of the region are overwritten
/// \param region the faces to be replaced
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{exact_conformal_class}
///     \cgalParamDescription{whether the region stays in its discrete conformal class}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{maximum number of steps}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{ends when a step moves no vertex by more than this multiple of the
///                           diagonal of the region}
///     \cgalParamType{`double`, positive}
///     \cgalParamDefault{1e-5}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{`go_further()` is asked before every step; false ends with the last
///                           surface}
///     \cgalParamType{a `std::reference_wrapper` of a model of `FlowVisitor`}
///     \cgalParamDefault{`Flow_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map, output_vertex_point_map, geom_traits}
///     \cgalParamDescription{see `spin_transform()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report, which converts to `true` if the surface is as smooth as possible: the
/// energies, the angles between the normals on both sides of the rim before and after, in radians,
/// and the distortion of the region. Otherwise, the surface is smoother than before.
/// \throw Precondition_error if the mesh is not an oriented manifold triangle mesh with finite
/// coordinates, no vertex of the region can move, a component of it has no rim, a face in or around
/// it has area zero, or a face is not of the mesh; the message names the offending element
/// \throw Solver_error if memory does not suffice. Where a matrix cannot be factored otherwise, the
/// fairing ends with the last surface, and the report says so. After any exception, the mesh is
/// unchanged.
template <class TriangleMesh, class FaceRange,
          class NamedParameters = parameters::Default_named_parameters>
internal::Fairing_report conformal_fairing(TriangleMesh& mesh, const FaceRange& region,
                                           const NamedParameters& np = parameters::default_values())
{
  static_assert(
      internal::only_known_parameters<
          NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
          CGAL::internal_np::number_of_iterations_t, CGAL::internal_np::visitor_t,
          internal_np::output_vertex_point_map_t, internal_np::exact_conformal_class_t,
          internal_np::tolerance_t>,
      "conformal_fairing(): unknown named parameter, see the manual for those it accepts");
  const std::string function = "conformal_fairing";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  Flow_visitor silent;
  auto&& visitor = internal::parameter_or(np, CGAL::internal_np::visitor, silent);
  internal::Fairing_result result = internal::fair_region(
      graph.view(), internal::read_region(graph, region, function),
      internal::fairing_options(np, function), function, [&] { return visitor.go_further(); });
  internal::write_points(mesh, graph, result.positions, np);
  return std::move(result.report);
}

}  // namespace Conformal_geometry_processing
