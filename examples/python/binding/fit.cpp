// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "binding.h"
#include "transformation.h"

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>

#include <optional>

namespace conformal_python {
namespace {

CGP::Nearest_spin_options nearest_options(const py::dict& options, const py::dict& bounds,
                                          const std::string& function)
{
  CGP::Nearest_spin_options o;
  o.direction = direction_of(options["direction"], function);
  o.keep_curvature = py::cast<bool>(options["keep_curvature"]);
  o.normal_weight = py::cast<double>(options["normal_weight"]);
  o.shear = py::cast<std::optional<double>>(options["shear"]);
  o.distance_tolerance = py::cast<double>(options["distance_tolerance"]);
  take(options, "max_scale", o.surface.scales.bound);
  take_closing(options, function, o.surface);
  o.surface.dirac = dirac_options(options, function);
  o.surface.limits = limits(bounds);
  return o;
}

/// (positions, spins, report, distance, normal_distance, sign_conflicts)
py::tuple nearest(const Array& V, const Array& target, const Indices& F, double blend,
                  const py::dict& options, const py::dict& bounds, const py::object& callback)
{
  const std::string function = "nearest";
  const CGP::Mesh_view mesh = mesh_view(V, F, function);
  const CGP::Points points = vertex_points(target, mesh.size_of_vertices(), function, "targets");
  const CGP::Nearest_spin_options own = nearest_options(options, bounds, function);
  const Eigen::VectorXd factors = take_numbers(options, "vertex_scale", function);
  const Watch watch(callback);
  int conflicts = 0;
  const CGP::Nearest_spin_result result = without_lock([&] {
    CGP::Nearest_spin_transformation search(mesh, points, function, own);
    if (factors.size() > 0) search.scale_lengths(factors);
    CGP::Nearest_spin_result found = search.transform(std::cref(watch));
    if (blend != 0 && found.report) found = search.blend(found, blend);
    conflicts = search.sign_conflicts();
    return found;
  });
  return py::make_tuple(to_rows(result.positions), to_rows(result.lambda), as_dict(result.report),
                        result.distance, result.normal_distance, conflicts);
}

struct Pair {
  CGP::Mesh_view a, b, start;
};

/// the spin transformation of `start` by t times the difference of a and b
/// \param tolerance of the search for the difference; without one, the plain difference
CGP::Spin_result blended(const Pair& meshes, double t, std::optional<double> tolerance,
                         const CGP::Dirac_options& options, const Watch& watch,
                         const std::string& function)
{
  const CGP::Points& p = meshes.b.positions();
  const CGP::Curvature_potential difference =
      tolerance ? CGP::nearest_curvature_difference(meshes.a, p, *tolerance, options,
                                                    std::cref(watch), function)
                : CGP::curvature_difference(meshes.a, p);
  CGP::Curvature_potential rho = CGP::transferred(difference, meshes.a, meshes.start);
  rho.values *= t;
  CGP::Spin_transformation_options own;
  own.dirac = options;
  own = CGP::blend_request(meshes.a, p, meshes.start, t, own);
  return CGP::Spin_transformation(meshes.start, own, function).transform(rho, std::cref(watch));
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
  std::optional<double> tolerance;
  if (!py::cast<bool>(options["keep_curvature"]))
    tolerance = py::cast<double>(options["distance_tolerance"]);
  return as_tuple(
      without_lock([&] { return blended(meshes, t, tolerance, dirac, watch, function); }));
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
