// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_DEFORM_H
#define CONFORMAL_DEFORM_H

#include "Session.h"
#include "Surface_input.h"
#include "solve_spin.h"

#include <string>

namespace conformal {

/// \brief What `conformal spin` and `conformal boundary` have in common: solves the problem, tells
/// the certificate, and writes the surface if it verifies.
/// \param problem with rho in the *user's frame*
/// \param easier what to try that asks for less
/// \throws Failure, Write_error
void deform(const Surface_input& input, Spin_problem problem, const Spin_options& options,
            const std::string& easier, Session& session);

}  // namespace conformal

#endif
