// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace conformal {

/// bytes as text of A-Z a-z 0-9 + / and = at the end (RFC 4648), without line breaks
std::string base64(std::string_view bytes);

/// the bytes of such a text, or none if it is another
std::string from_base64(std::string_view text);

}  // namespace conformal
