// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Report.h"

#include "conformal/input/Surface_input.h"

#include <string>

namespace conformal {

/// Enters the counts of an input into the report (`input/...`).
void report_input(const Surface_input& input, Report& report, const std::string& place = "input");

}  // namespace conformal
