// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "spin.h"

#include "spin_components.h"

#include "conformal/input/boundary_condition.h"
#include "conformal/input/rho.h"
#include "conformal/process/Failure.h"
#include "conformal/transform/deform.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/mesh/topology.h>

namespace conformal {
namespace {

void require_standard_problem_at_boundary(const Surface_input& input, const Spin_options& options)
{
  if (options.generalized && !CGP::topology(input.mesh).is_closed())
    throw unsuitable(options.input,
                     "--problem generalized wants a closed surface; try: --problem standard");
}

}  // namespace

void require_possible_spin(const Surface_input& input, const Spin_options& options)
{
  require_boundary_to_keep(input, options.boundary);
  require_standard_problem_at_boundary(input, options);
}

std::string easier_spin(const Spin_options& options)
{
  const bool is_tried = options.mollification.value_or(1) > 0;
  return is_tried ? "a weaker rho" : "a weaker rho, --mollify for thin faces";
}

void spin(const Spin_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input =
      read_suitable_surface(options.input, session, flat_faces(options.mollification));
  const bool is_whole = !session.options().each_component;
  if (is_whole) require_possible_spin(input, options);
  Spin_problem problem;
  problem.rho = read_rho(input, options.rho);
  if (options.generalized && problem.rho.on == CGP::Curvature_potential::On::vertices)
    throw Failure(Exit_code::usage, "--problem generalized wants rho on faces; try: --on faces");
  problem.boundary = kept_boundary(options.boundary);
  problem.closes_loops = !options.open_handles;
  problem.mollification = options.mollification.value_or(0);
  if (!options.mollification) problem.second_try = 1e-6;
  is_whole ? deform(input, std::move(problem), options, easier_spin(options), session)
           : spin_components(input, std::move(problem), options, session);
}

}  // namespace conformal
