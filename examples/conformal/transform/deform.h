// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_TRANSFORM_DEFORM_H
#define CONFORMAL_TRANSFORM_DEFORM_H

#include "solve_spin.h"

#include "conformal/input/Surface_input.h"
#include "conformal/report/Session.h"

#include <functional>
#include <string>

namespace conformal {

/// A computed surface, and the problem
struct Deformation {
  CGP::Curvature_potential rho;  ///< in the *user's frame*
  CGP::Boundary_condition boundary;
  Spin_solution solution;
};

using Go_further = std::function<bool(const CGP::Eigensolver_progress&)>;

/// \brief Solves under a line of progress, unless a signal comes.
/// \param part said before the words of progress
/// \throws Failure if one has come, and what `solve` throws
Spin_solution watched(const std::function<Spin_solution(const Go_further&)>& solve,
                      const Common_options& common, const std::string& part = "");

/// Enters the certificate and what came of the boundary into the report, and prints them.
void tell_certificate(const Surface_input& input, const Deformation& deformation, Session& session);

/// \brief Verifies a result, and reports changes that were not requested.
/// \param what the cause, for the message
/// \param easier advice for an easier problem
/// \throws Failure if it does not verify, unless the options force it
void verify(const std::string& what, const Surface_input& input, const Spin_solution& solution,
            const Spin_options& options, const std::string& easier, Session& session);

/// Writes the surface into a file. \throws Write_error
void write_deformation(const std::string& path, const Surface_input& input,
                       const Deformation& deformation, const std::string& lambda, Session& session);

/// \brief Common part of `conformal spin` and `conformal boundary`: solves the problem, prints the
/// certificate, and writes the surface if it verifies.
/// \param problem with rho in the *user's frame*
/// \param easier advice for an easier problem
/// \throws Failure, Write_error
void deform(const Surface_input& input, Spin_problem problem, const Spin_options& options,
            const std::string& easier, Session& session);

}  // namespace conformal

#endif
