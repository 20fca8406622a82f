// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace conformal {

/// \brief the least limit of memory, in bytes, among those of the control groups that this process
/// belongs to and of the groups around them, as a container has; infinite if there is none.
///
/// Reads version 1 (memory.limit_in_bytes) and version 2 (memory.max). A container may see its own
/// group as the root of the tree, whatever path /proc tells: files that are not there have no
/// limit.
/// \param root of the file system
double memory_of_control_groups(const std::string& root = "");

/// \brief the memory, in bytes, that this process may take in the end: that of the machine, or less
/// in a container
double machine_memory();

}  // namespace conformal
