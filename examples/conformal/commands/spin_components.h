// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_SPIN_COMPONENTS_H
#define CONFORMAL_COMMANDS_SPIN_COMPONENTS_H

#include "conformal/input/Surface_input.h"
#include "conformal/report/Session.h"
#include "conformal/transform/solve_spin.h"

namespace conformal {

/// \brief What `conformal spin --each-component` does: `deform()` for each component.
/// \param problem with rho in the *user's frame* of the whole surface
/// \throws Failure, Write_error
void spin_components(const Surface_input& input, Spin_problem problem, const Spin_options& options,
                     Session& session);

}  // namespace conformal

#endif
