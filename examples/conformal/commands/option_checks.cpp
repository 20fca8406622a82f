// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "option_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace conformal {
namespace {

/// the number that the text consists of, or not a number; none is so large that its square, or its
/// product with a length, could overflow
double number(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return *end == 0 && std::abs(value) <= 1e150 ? value : std::nan("");
}

}  // namespace

std::string above_zero(const std::string& text)
{
  return number(text) > 0 ? "" : "wanted a number above 0";
}

std::string finite(const std::string& text)
{
  return std::isfinite(number(text)) ? "" : "wanted a finite number, of at most 1e150";
}

std::string below_one(const std::string& text)
{
  const double value = number(text);
  return value >= 0 && value < 1 ? "" : "wanted a number between 0 and 1";
}

std::string between_zero_and_one(const std::string& text)
{
  const double value = number(text);
  return value > 0 && value < 1 ? "" : "wanted a number between 0 and 1";
}

std::string file_name(const std::string& text)
{
  const bool is_name = !text.empty() && text != "-";
  return is_name ? "" : "wanted the name of a file";
}

std::string formula(const std::string& text)
{
  const bool is_blank = text.find_first_not_of(" \t\r\n") == std::string::npos;
  return is_blank ? "an empty formula, wanted one such as sin(5*y)" : "";
}

std::string not_empty(const std::string& text)
{
  return text.empty() ? "wanted a name" : "";
}

std::string property_name(const std::string& text)
{
  const auto is_part = [](char c) { return c > ' ' && c != '\x7f'; };
  const bool is_word = !text.empty() && std::all_of(text.begin(), text.end(), is_part);
  return is_word ? "" : "wanted one word of letters, digits and the like";
}

}  // namespace conformal
