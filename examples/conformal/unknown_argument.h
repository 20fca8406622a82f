// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace conformal {

/// \brief What is wrong with the first argument that no option and no input has taken, and which
/// options may have been meant; empty if there is no such argument.
/// \param app has parsed the command line, and may have failed
std::string fault_of_unknown_argument(const CLI::App& app);

/// the command that lists the options: `conformal spin --help`
std::string help_command(const CLI::App& app);

}  // namespace conformal
