// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_INFO_H
#define CONFORMAL_INFO_H

#include "Session.h"
#include "Surface_input.h"

namespace conformal {

/// Tells about any surface that can be read: `conformal info`.
/// \throws Failure under --strict if the surface cannot be transformed
void info(const Info_options& options, Session& session);

/// Enters the counts of an input into the report (`input/...`).
void report_input(const Surface_input& input, Report& report, const std::string& place = "input");

}  // namespace conformal

#endif
