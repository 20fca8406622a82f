// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace conformal {

/// \brief A formula of the user in x, y, z, nx, ny, nz, possibly further variables, and the
/// constants pi and e.
///
/// Besides the functions of muParser (sin ... atan2, exp, ln, log10, sqrt, abs, sign, min, max,
/// `a < b ? c : d`) it supports gauss(d, s) = exp(-d^2 / (2 s^2)), and bump(d, r), which is 1 at
/// d = 0, smooth, and 0 for |d| > r.
class Expression {
 public:
  /// \param option whose value the text is
  /// \param more names of variables beside the six
  /// \throws Failure (usage) that names the place of the fault, counted from 1, the formula that
  /// may have been meant, and what there is
  explicit Expression(const std::string& text, const std::string& option = "--rho-expression",
                      const std::vector<std::string>& more = {});
  ~Expression();
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;

  /// its value at a point with a normal; may be no number, as 0/0 is
  /// \param more a value for each variable beside the six
  double operator()(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                    const std::vector<double>& more = {});

 private:
  struct Parser;
  std::unique_ptr<Parser> m_parser;
};

}  // namespace conformal
