// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace conformal {

/// The property of vertices that an attribute of an application is: `rho` for `_RHO`, as glTF
/// demands the underscore and other programs expect capitals; nothing for any other attribute.
std::optional<std::string> property_of(const std::string& attribute);

/// The attribute that is read as this property, or nothing
std::optional<std::string> attribute_of(const std::string& property);

}  // namespace conformal
