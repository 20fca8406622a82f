// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "options.h"

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Core>

#include <vector>

namespace conformal_python {
namespace {

/// the rows of the boundary vertices, of an array with a row for every vertex
CGP::Points at_boundary(const py::object& array, const std::vector<int>& vertices,
                        const CGP::Mesh_view& mesh, const std::string& function,
                        const std::string& what)
{
  if (array.is_none()) return CGP::Points(3, 0);
  const CGP::Points all =
      vertex_points(array.cast<Array>(), mesh.size_of_vertices(), function, what);
  return all(Eigen::indexing::all, vertices);
}

/// normals of the surface with the target points, where none are given
CGP::Points normals_of(const py::object& targets, const std::vector<int>& vertices,
                       const CGP::Mesh_view& mesh)
{
  CGP::Mesh_view moved = mesh;
  moved.set_positions(points(targets.cast<Array>(), "", ""));
  return vertex_normals(moved, CGP::internal::Normal_weight::angle)(Eigen::indexing::all, vertices);
}

}  // namespace

Eigen::VectorXd take_numbers(const py::dict& options, const char* name, const std::string& function)
{
  Array given;
  take(options, name, given);
  if (given.size() == 0 && options.contains(name) && !options[name].is_none())
    throw CGP::Precondition_error(function, std::string(name) + " is empty");
  return given.size() == 0 ? Eigen::VectorXd() : numbers(given, function, name);
}

void take_closing(const py::dict& options, const std::string& function,
                  CGP::Spin_transformation_options& o)
{
  CGP::Exactness chosen = CGP::Exactness::adjoint;
  choose(options, "exactness",
         {{"adjoint", CGP::Exactness::adjoint}, {"thesis", CGP::Exactness::thesis}}, chosen,
         function);
  o.exactness = chosen;
  if (options.contains("exactness") && options["exactness"].is_none()) o.exactness.reset();
  take(options, "max_period_defect", o.max_period_defect);
  take(options, "mollification", o.mollification);
}

Eigen::Vector3d direction_of(const py::object& direction, const std::string& function)
{
  const Eigen::VectorXd d = numbers(direction.cast<Array>(), function, "a direction");
  if (d.size() != 3)
    throw CGP::Precondition_error(function, "a direction has three coefficients, (t, n, b)");
  return d;
}

CGP::Boundary_condition boundary_condition(const py::object& condition, const CGP::Mesh_view& mesh,
                                           const std::string& function)
{
  if (condition.is_none()) return {};
  const auto kind = condition.attr("kind").cast<std::string>();
  if (kind == "free") return {};
  require_manifold(mesh, function);
  const std::vector<int> vertices = boundary_frames(mesh).vertices;
  const py::object targets = condition.attr("targets"), normals = condition.attr("normals");
  if (kind == "directions")
    return CGP::Boundary_condition::directions(
        Eigen::Vector3d(
            numbers(condition.attr("direction").cast<Array>(), function, "a direction")),
        at_boundary(targets, vertices, mesh, function, "directions"));
  CGP::Points p = at_boundary(targets, vertices, mesh, function, "positions");
  return CGP::Boundary_condition::positions(
      std::move(p),
      normals.is_none() ? normals_of(targets, vertices, mesh)
                        : at_boundary(normals, vertices, mesh, function, "normals"),
      condition.attr("weight").cast<double>());
}

CGP::Dirac_options dirac_options(const py::dict& options, const std::string& function)
{
  using Branch = CGP::Dirac_options::Branch;
  using Problem = CGP::Dirac_options::Eigenproblem;
  CGP::Dirac_options o;
  choose(options, "eigenproblem",
         {{"standard", Problem::standard}, {"generalized", Problem::generalized}}, o.problem,
         function);
  choose(options, "branch",
         {{"nearest", Branch::nearest}, {"smallest", Branch::smallest}, {"zero", Branch::zero}},
         o.branch, function);
  take(options, "tolerance", o.tolerance);
  take(options, "max_iterations", o.max_iterations);
  take(options, "max_substeps", o.max_substeps);
  take(options, "random_seed", o.random_seed);
  take(options, "kernel_tolerance", o.kernel_tolerance);
  return o;
}

void take_surface(const py::dict& options, const CGP::Mesh_view& mesh, const std::string& function,
                  CGP::Spin_transformation_options& o)
{
  py::object condition = py::none();
  take(options, "boundary", condition);
  o.boundary = boundary_condition(condition, mesh, function);
  take_closing(options, function, o);
  take(options, "exact_conformal_class", o.exact_conformal_class);
}

CGP::Spin_transformation_options transformation_options(const py::dict& options,
                                                        const CGP::Mesh_view& mesh,
                                                        const std::string& function)
{
  CGP::Spin_transformation_options o;
  take_surface(options, mesh, function, o);
  o.scales.factors = take_numbers(options, "vertex_scale", function);
  o.scales.weights = take_numbers(options, "vertex_scale_weight", function);
  if (options.contains("max_scale"))
    take(options, "max_scale", o.scales.bound);
  else
    o.scales.bound = CGP::internal::default_bound(o);
  return o;
}

CGP::Spin_report::Limits limits(const py::dict& options)
{
  CGP::Spin_report::Limits l;
  take(options, "residual", l.residual);
  take(options, "closure", l.closure);
  take(options, "direction_error", l.direction_error);
  take(options, "gamma_radius", l.gamma_radius);
  take(options, "realised_share", l.realised_share);
  take(options, "kept_norm", l.kept_norm);
  take(options, "agreement", l.agreement);
  take(options, "opposition", l.opposition);
  take(options, "quasi_conformal", l.map.quasi_conformal);
  take(options, "flipped_share", l.map.flipped_share);
  take(options, "collapsed_share", l.map.collapsed_share);
  return l;
}

}  // namespace conformal_python
