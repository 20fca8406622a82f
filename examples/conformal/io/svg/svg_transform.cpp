// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "svg_transform.h"

#include "conformal/io/file/numbers.h"

#include <algorithm>
#include <cmath>

namespace conformal {
namespace {

constexpr std::string_view separators = " \t\r\n,";

double radians(double degrees)
{
  return degrees * std::acos(-1.) / 180;
}

std::vector<double> numbers(std::string_view text, const Svg_fault& fault)
{
  std::vector<double> values;
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
    if (text.empty()) return values;
    const std::string_view word = text.substr(0, text.find_first_of(separators));
    const auto value = parse_double(word);
    if (!value || !std::isfinite(*value)) fault(in_quotes(word) + " is not a number");
    values.push_back(*value);
    text.remove_prefix(word.size());
  }
}

Eigen::Affine2d affine(double a, double b, double c, double d, double e, double f)
{
  Eigen::Affine2d map;
  map.matrix() << a, c, e, b, d, f, 0, 0, 1;
  return map;
}

/// one function of a transformation; `v` are its arguments
Eigen::Affine2d map_of(std::string_view name, const std::vector<double>& v, const Svg_fault& fault)
{
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return affine(v[0], v[1], v[2], v[3], v[4], v[5]);
  if (name == "translate" && (n == 1 || n == 2)) return affine(1, 0, 0, 1, v[0], n == 2 ? v[1] : 0);
  if (name == "scale" && (n == 1 || n == 2)) return affine(v[0], 0, 0, v[n - 1], 0, 0);
  if (name == "skewX" && n == 1) return affine(1, 0, std::tan(radians(v[0])), 1, 0, 0);
  if (name == "skewY" && n == 1) return affine(1, std::tan(radians(v[0])), 0, 1, 0, 0);
  if (name == "rotate" && (n == 1 || n == 3)) {
    const double c = std::cos(radians(v[0])), s = std::sin(radians(v[0]));
    const Eigen::Vector2d center = n == 3 ? Eigen::Vector2d(v[1], v[2]) : Eigen::Vector2d(0, 0);
    const Eigen::Affine2d turn = affine(c, s, -s, c, 0, 0);
    return Eigen::Translation2d(center) * turn * Eigen::Translation2d(-center);
  }
  fault("the transformation " + in_quotes(name) + " with " + std::to_string(n) +
        " numbers is not understood");
  return Eigen::Affine2d::Identity();
}

}  // namespace

Eigen::Affine2d parse_svg_transform(std::string_view text, const Svg_fault& fault)
{
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
    if (text.empty()) return map;
    const std::size_t open = text.find('('), close = text.find(')');
    if (close == text.npos || open > close)
      fault("the transformation " + in_quotes(text) + " is not understood");
    std::string_view name = text.substr(0, open);
    name = name.substr(0, name.find_first_of(separators));
    map = map * map_of(name, numbers(text.substr(open + 1, close - open - 1), fault), fault);
    text.remove_prefix(close + 1);
  }
}

}  // namespace conformal
