// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

namespace Conformal_geometry_processing::internal {

/// \brief Reads how the eigenvector is found: by `dirac`, where the parameters that other functions
/// have, too, take precedence.
template <class NamedParameters>
void read_dirac_options(const NamedParameters& np, Dirac_options& o)
{
  read_parameter(np, internal_np::dirac, o);
  read_parameter(np, internal_np::tolerance, o.tolerance);
  read_parameter(np, CGAL::internal_np::number_of_iterations, o.max_iterations);
  read_parameter(np, CGAL::internal_np::random_seed, o.random_seed);
}

/// the solvers that named parameters tell of
template <class NamedParameters>
Spin_solvers spin_solvers(const NamedParameters& np)
{
  return parameter_or(np, internal_np::sparse_solver, Spin_solvers());
}

/// passes the progress of an eigensolver to the visitor of the named parameters, and asks whether
/// to go further; the visitor must outlive it
template <class Visitor>
auto asking(Visitor& visitor)
{
  return [&visitor](const Eigensolver_progress& progress) {
    visitor.on_iteration(progress);
    return visitor.go_further();
  };
}

}  // namespace Conformal_geometry_processing::internal
