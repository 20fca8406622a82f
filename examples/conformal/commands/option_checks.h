// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace conformal {

// Checks of the text of an option: an empty string if all is well, or what is wanted.

std::string above_zero(const std::string& text);
std::string below_one(const std::string& text);  // and above zero
std::string between_zero_and_one(const std::string& text);
std::string finite(const std::string& text);
std::string file_name(const std::string& text);  // of an output: standard output has none
std::string formula(const std::string& text);
std::string not_empty(const std::string& text);
std::string property_name(const std::string& text);  // of a PLY header: one printable word

}  // namespace conformal
