// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "spin_components.h"

#include "spin.h"

#include "conformal/input/rho.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/transform/deform.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/solve_twice.h"

#include <utility>

namespace conformal {
namespace {

/// the part of the problem that a component has
Spin_problem problem_of(const Component& component, const Spin_problem& whole)
{
  const bool on_faces = whole.rho.on == CGP::Curvature_potential::On::faces;
  Spin_problem own = whole;
  own.rho.values = whole.rho.values(on_faces ? component.faces : component.vertices);
  return own;
}

/// Solves the problem of a component, and judges the solution.
Spin_solution solved(const Component& component, const Spin_problem& problem,
                     const Spin_options& options, const Common_options& common, Session& own)
{
  require_possible_spin(component.input, options);
  const Deformation deformation{
      problem.rho, problem.boundary,
      solve_twice(component.input.mesh, problem, options, common, component.name + ": ")};
  tell_certificate(component.input, deformation, own);
  verify(component.input.file.path, component.input, deformation.solution, options,
         easier_spin(options), own);
  return deformation.solution;
}

}  // namespace

void spin_components(const Surface_input& input, Spin_problem problem, const Spin_options& options,
                     Session& session)
{
  session.end_stage("prepare");
  Deformation whole{problem.rho, problem.boundary, {}};
  whole.solution.lambda.resize(input.mesh.size_of_vertices());
  problem.rho.values /= User_frame(input.mesh).unit();
  whole.solution.positions =
      each_component(input, session, [&](const Component& component, Session& own) {
        const Spin_solution solution =
            solved(component, problem_of(component, problem), options, session.options(), own);
        whole.solution.lambda(component.vertices) = solution.lambda;
        return solution.positions;
      });
  keep_exhibit(input, whole.solution.positions, session);
  write_deformation(session.options().output, input, whole, options.lambda, session);
  session.end_stage("write");
}

}  // namespace conformal
