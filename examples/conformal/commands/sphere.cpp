// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "sphere.h"

#include "conformal/input/Surface_input.h"
#include "conformal/io/write_surface.h"
#include "conformal/process/Failure.h"
#include "conformal/process/interruption.h"
#include "conformal/report/Table.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/surfaces/dirac_sphere.h>
#include <Conformal_geometry_processing/surfaces/geodesic_sphere.h>

#include <cmath>
#include <numeric>
#include <string>

namespace conformal {
namespace {

/// A mesh as if it had been read.
Surface_input as_input(const CGP::Mesh_view& mesh)
{
  Surface_input input;
  input.mesh = mesh;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    input.file.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto& corners : mesh.corners()) {
    input.file.polygons.corners.insert(input.file.polygons.corners.end(), corners.begin(),
                                       corners.end());
    input.file.polygons.first.push_back(input.file.polygons.corners.size());
  }
  input.file.vertices.size = input.file.points.size();
  input.file.faces.size = input.file.polygons.size();
  input.vertex_in_file.resize(input.file.points.size());
  std::iota(input.vertex_in_file.begin(), input.vertex_in_file.end(), 0);
  input.face_in_file.resize(input.file.polygons.size());
  std::iota(input.face_in_file.begin(), input.face_in_file.end(), 0);
  return input;
}

CGP::Spin_result dirac_sphere(const CGP::Mesh_view& mesh, const Sphere_options& options)
{
  try {
    CGP::require_spherical_spinor(options.kappa, options.s, "sphere");
  } catch (const CGP::Precondition_error& error) {
    throw Failure(Exit_code::usage, error.message());
  }
  return CGP::spin_to_dirac_sphere(mesh, options.kappa, options.s, "sphere");
}

void tell(const CGP::Spin_result& result, const CGP::Mesh_view& mesh, Session& session)
{
  const double pi = std::acos(-1.);
  Table table;
  const auto tell_number = [&](const std::string& place, const std::string& label, double value) {
    session.report().set("result/" + place, value);
    table.add(label, value);
  };
  tell_number("eigenvalue", "eigenvalue", result.report.eigenvalue);
  tell_number("willmore_energy", "Willmore energy, in 4 pi",
              CGP::willmore_energy(CGP::Mesh_view(result.positions, mesh.corners())) / (4 * pi));
  tell_number("closure_residual", "closure, relative", result.report.closure_residual);
  const auto& Q = result.report.conformality.quasi_conformal;
  tell_number("quasi_conformal/mean", "quasi-conformal error, mean", Q.mean);
  tell_number("quasi_conformal/max", "quasi-conformal error, greatest", Q.max);
  tell_number("min_spin_ratio", "smallest |lambda| / greatest", result.report.min_spin_ratio);
  session.print(table.text());
}

}  // namespace

void sphere(const Sphere_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input = as_input(CGP::geodesic_sphere(1 << options.level));
  const CGP::Spin_result result = dirac_sphere(input.mesh, options);
  throw_if_interrupted();
  session.end_stage("solve");
  Surface_file file = moved(input, result.positions);
  set_quality(input, result.positions, file);
  session.note_all(write_surface(session.options().output, file));
  session.end_stage("write");
  tell(result, input.mesh, session);
}

}  // namespace conformal
