// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "binding.h"
#include "transformation.h"

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>
#include <Conformal_geometry_processing/spin/turned_binormals.h>

#include <optional>
#include <utility>

namespace conformal_python {
namespace {

CGP::Nearest_spin_options nearest_options(const py::dict& options, const std::string& function)
{
  CGP::Nearest_spin_options o;
  o.direction = direction_of(options["direction"], function);
  o.keep_curvature = py::cast<bool>(options["keep_curvature"]);
  o.normal_weight = py::cast<double>(options["normal_weight"]);
  take_closing(options, function, o);
  return o;
}

/// (positions, spins, report, distance, normal_distance, sign_conflicts)
py::tuple nearest(const Array& V, const Array& target, const Indices& F, double blend,
                  const py::dict& options, const py::dict& bounds, const py::object& callback)
{
  const std::string function = "nearest";
  const CGP::Mesh_view mesh = mesh_view(V, F, function);
  const CGP::Points points = vertex_points(target, mesh.size_of_vertices(), function, "targets");
  const CGP::Nearest_spin_options own = nearest_options(options, function);
  const CGP::Dirac_options dirac = dirac_options(options, function);
  const Eigen::VectorXd factors = take_numbers(options, "vertex_scale", function);
  const CGP::Spin_report::Limits limits = conformal_python::limits(bounds);
  const Watch watch(callback);
  int conflicts = 0;
  const CGP::Nearest_spin_result result = without_lock([&] {
    CGP::Nearest_spin_transformation<> search(mesh, points, function, own);
    if (factors.size() > 0) search.scale_lengths(factors);
    CGP::Nearest_spin_result found = search.transform(dirac, std::cref(watch));
    found.report.limits = limits;
    if (blend != 0 && found.report) found = search.blend(found, blend);
    found.report.limits = limits;
    conflicts = search.sign_conflicts();
    return found;
  });
  return py::make_tuple(to_rows(result.positions), to_rows(result.lambda), as_dict(result.report),
                        result.distance, result.normal_distance, conflicts);
}

struct Pair {
  CGP::Mesh_view a, b, start;
};

/// the rho that transforms a into b, or into the surface nearest to it; if there is none or the
/// curvature is kept, the difference of curvature
CGP::Curvature_potential difference(const Pair& meshes, bool keep_curvature,
                                    const CGP::Dirac_options& options, const Watch& watch,
                                    const std::string& function)
{
  const CGP::Points& p = meshes.b.positions();
  if (!keep_curvature) {
    CGP::Nearest_spin_options own;
    own.direction = {0, 0, 1};
    CGP::Nearest_spin_transformation<> search(meshes.a, p, function, own);
    CGP::Nearest_spin_result found = search.transform(options, std::cref(watch));
    const bool has_direction =
        CGP::topology(meshes.a).is_closed() || found.direction == own.direction;
    if (found.report && found.distance < found.source_distance && has_direction)
      return std::move(found.rho);
  }
  return CGP::curvature_difference(meshes.a, p);
}

/// the spin transformation of `start` by t times the difference of a and b
CGP::Spin_result blended(const Pair& meshes, double t, bool keep_curvature,
                         const CGP::Dirac_options& options, const Watch& watch,
                         const std::string& function)
{
  const CGP::Points& p = meshes.b.positions();
  CGP::Curvature_potential rho = CGP::transferred(
      difference(meshes, keep_curvature, options, watch, function), meshes.a, meshes.start);
  rho.values *= t;
  CGP::Spin_transformation_options own;
  if (!CGP::topology(meshes.start).is_closed()) {
    const CGP::Mesh_view aligned(CGP::align(p, meshes.a.positions()).apply(p), meshes.a.corners());
    own.boundary = CGP::Boundary_condition::binormals(
        CGP::turned_binormals(meshes.a, aligned, meshes.start, t));
    own.exactness.reset();  // the prescribed data determine the loops
  }
  return CGP::Spin_transformation<>(meshes.start, own, function)
      .transform(rho, options, std::cref(watch));
}

py::tuple blend(const Array& A, const Array& B, const Array& onto, const Indices& F, double t,
                const py::dict& options, const py::object& callback)
{
  const std::string function = "blend";
  const Pair meshes{mesh_view(A, F, function), mesh_view(B, F, function),
                    mesh_view(onto, F, function)};
  for (const CGP::Mesh_view* mesh : {&meshes.a, &meshes.b, &meshes.start})
    require_surface(*mesh, function);
  if (!std::isfinite(t)) throw CGP::Precondition_error(function, "t is not finite");
  const CGP::Dirac_options dirac = dirac_options(options, function);
  const Watch watch(callback);
  const bool keep_curvature = py::cast<bool>(options["keep_curvature"]);
  return as_tuple(
      without_lock([&] { return blended(meshes, t, keep_curvature, dirac, watch, function); }));
}

}  // namespace

void add_fit(py::module_& m)
{
  using py::arg;
  m.def("nearest", &nearest, arg("V"), arg("target"), arg("F"), arg("blend"), arg("options"),
        arg("limits"), arg("callback"));
  m.def("blend", &blend, arg("A"), arg("B"), arg("onto"), arg("F"), arg("t"), arg("options"),
        arg("callback"));
}

}  // namespace conformal_python
