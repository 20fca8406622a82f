// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Exhibit.h"

#include <string>

namespace conformal {

/// \brief Creates a self-contained page that shows a run, and needs no network.
///
/// It contains the report and, of the exhibit, each in its own frame: `before` and
/// `after` (float32, 3 per vertex), `faces` (uint32, 3 per face), `quality` (float32, Q of each
/// face), `squares` (float32, 2 per corner), `rho` (float32, of each face, or nothing), in base64
/// and little endian.
/// \param json the report
/// \pre `why_no_html_reports()` is empty
std::string html_report(const Exhibit& exhibit, const std::string& json);

/// why this program cannot write such pages, and how to build one that can; empty if it can
std::string why_no_html_reports();

}  // namespace conformal
