// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace conformal {

/// \brief Keeps the line on stderr that tells how far the work is, where stderr is not a terminal.
///
/// A signal handler writes it every ten seconds, also while a factorization takes longer, which
/// has no callback.
/// \param text what the work does; empty: nothing is told
void set_status(const std::string& text);

/// Writes the line with the seconds since the program began. Safe to call in a signal handler.
void write_status() noexcept;

}  // namespace conformal
