// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "boundary.h"

#include "conformal/input/boundary_condition.h"
#include "conformal/input/rho.h"
#include "conformal/input/same_faces.h"
#include "conformal/transform/deform.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

namespace conformal {
namespace {

bool has_source(const Rho_options& rho)
{
  return !(rho.expression.empty() && rho.property.empty() && rho.file.empty() && rho.image.empty());
}

/// rho in the user's frame
CGP::Curvature_potential potential(const Surface_input& input, const Boundary_options& options)
{
  if (has_source(options.spin.rho)) return read_rho(input, options.spin.rho);
  if (!options.minimal) return CGP::no_potential(input.mesh);
  const double unit = User_frame(input.mesh).unit();
  return CGP::Curvature_potential::on_vertices(-unit * CGP::mean_curvature(input.mesh));
}

}  // namespace

void boundary(const Boundary_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input = read_bounded_surface(options.spin.input, session);
  Spin_problem problem;
  problem.rho = potential(input, options);
  const Prescription_options& by = options.prescription;
  problem.boundary = prescribed_boundary(input, by);
  session.note_all(
      notes_of_repair_alike(input, {by.tangents_from, by.binormals_from, by.positions_from}));
  // The prescribed data determine the loops: they close, or the residual is large.
  problem.closes_loops = false;
  if (options.minimal) problem.kernel_tolerance = CGP::minimal_kernel_tolerance(input.mesh);
  deform(input, std::move(problem), options.spin, "a gentler change of the directions", session);
}

}  // namespace conformal
