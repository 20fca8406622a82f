// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace conformal {

/// what a formula may contain
struct Formula_names {
  std::vector<std::string> values;  ///< variables and constants
  std::vector<std::string> functions;
};

/// \brief What may have been meant by a formula in another notation than that of muParser.
///
/// `x**2` is x^2, `2x` and `(x)(y)` are products, `sin x` is sin(x), `1,5` is 1.5, `pow(x,2)` is
/// x^2, `np.sin` is sin, `Sin` and `sine` are sin, `sin(x` lacks a parenthesis, and `f = x` is x.
/// The result need not be a formula either, and is the text itself if nothing is recognised.
std::string corrected_formula(const std::string& text, const Formula_names& names);

}  // namespace conformal
