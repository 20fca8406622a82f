// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// a part of a formula
struct Formula_token {
  enum class Kind { number, name, opening, closing, comma, other };

  Kind kind;
  std::string text;
  std::string blanks = {};  ///< before it
};

using Formula_tokens = std::vector<Formula_token>;

Formula_tokens formula_tokens(std::string_view text);

std::string formula_of(const Formula_tokens& tokens);

/// the token that closes the parenthesis, or the number of tokens
/// \pre `tokens[opening]` opens one
std::size_t closing_of(const Formula_tokens& tokens, std::size_t opening);

}  // namespace conformal
