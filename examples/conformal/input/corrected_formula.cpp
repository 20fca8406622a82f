// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "corrected_formula.h"

#include "formula_tokens.h"

#include "conformal/process/near_names.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <utility>

namespace conformal {
namespace {

using Kind = Formula_token::Kind;
using Names = std::vector<std::string>;

bool has(const Names& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Signs of other languages and of keyboards
std::string with_plain_signs(std::string text)
{
  const std::initializer_list<std::pair<const char*, const char*>> signs = {
      {"**", "^"},
      {"\xc2\xb2", "^2"},
      {"\xc2\xb3", "^3"},
      {"\xc3\x97", "*"},
      {"\xc2\xb7", "*"},
      {"\xc3\xb7", "/"},
      {"\xe2\x88\x92", "-"},
      {"\xe2\x80\x93", "-"},
      {"\xcf\x80", "pi"},
      {"\xe2\x8b\x85", "*"},
      {"\xe2\x88\x9a", "sqrt"},
      {"[", "("},
      {"{", "("},
      {"]", ")"},
      {"}", ")"},
      {"numpy.", ""},
      {"math.", ""},
      {"Math.", ""},
      {"np.", ""},
      {";", ","},
      {"\"", ""}};
  for (const auto& [sign, plain] : signs)
    for (std::size_t i = text.find(sign); i != std::string::npos; i = text.find(sign, i))
      text.replace(i, std::string(sign).size(), plain);
  const std::size_t end = text.find_last_not_of(" ,");
  return text.substr(0, end == std::string::npos ? 0 : end + 1);
}

/// `f = x` and `f(x, y) = x` as x
Formula_tokens right_side(Formula_tokens tokens)
{
  const auto is_sign = [](const Formula_token& t) { return t.text == "="; };
  const auto sign = std::find_if(tokens.begin(), tokens.end(), is_sign);
  if (sign == tokens.end() || tokens.front().kind != Kind::name) return tokens;
  const bool is_call = tokens.size() > 1 && tokens[1].kind == Kind::opening;
  const std::size_t end = is_call ? closing_of(tokens, 1) + 1 : 1;
  if (sign != tokens.begin() + static_cast<std::ptrdiff_t>(std::min(end, tokens.size())))
    return tokens;
  if (sign + 1 != tokens.end() && (sign + 1)->text == "=") return tokens;  // compares
  tokens.erase(tokens.begin(), sign + 1);
  if (!tokens.empty()) tokens.front().blanks.clear();
  return tokens;
}

/// `1,5` outside of parentheses as 1.5
Formula_tokens with_decimal_points(const Formula_tokens& tokens)
{
  Formula_tokens result;
  int depth = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Formula_token& token = tokens[i];
    depth += token.kind == Kind::opening ? 1 : token.kind == Kind::closing ? -1 : 0;
    const bool is_point = depth == 0 && token.kind == Kind::comma && i > 0 &&
                          i + 1 < tokens.size() && tokens[i - 1].kind == Kind::number &&
                          tokens[i + 1].kind == Kind::number;
    if (is_point)
      result.back().text += '.' + tokens[++i].text;
    else
      result.push_back(token);
  }
  return result;
}

/// `xy` as x and y, `sinx` as sin and x; empty if the name does not consist of known ones
Names parts_of(const std::string& name, const Formula_names& names)
{
  for (std::size_t size = name.size(); size > 0; --size) {
    const std::string first = name.substr(0, size), rest = name.substr(size);
    if (!has(names.values, first) && !has(names.functions, first)) continue;
    if (rest.empty()) return {first};
    Names parts = parts_of(rest, names);
    if (parts.empty()) continue;
    parts.insert(parts.begin(), first);
    return parts;
  }
  return {};
}

/// whether every function is followed by its argument
bool is_product(const Names& parts, const Names& functions, bool is_called)
{
  if (parts.empty()) return false;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (has(functions, parts[i]) && i + (is_called ? 1 : 2) != parts.size()) return false;
  return true;
}

/// the known names that a name stands for, itself if there are none
Names meant_by(const std::string& name, const Formula_names& names, bool is_called)
{
  const std::initializer_list<std::pair<const char*, const char*>> others = {
      {"arcsin", "asin"}, {"arccos", "acos"}, {"arctan", "atan"}, {"tg", "tan"},
      {"fabs", "abs"},    {"sgn", "sign"},    {"round", "rint"}};
  std::string own = name;
  for (char& c : own)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const auto& [other, known] : others)
    if (own == other) own = known;
  if (own == "pow") return {own};
  // Functions of other languages, which are others than those with near names
  const Names unknown = {"cot",   "coth", "acot", "acoth", "sec",  "csc", "log1p",
                         "expm1", "exp2", "int",  "sinc",  "cosc", "mod", "mid"};
  constexpr std::size_t longest = 30;  // of what is taken apart, which takes cubic time
  if (has(unknown, own) || own.size() > longest) return {name};
  const Names parts = parts_of(own, names);
  const bool is_alone = parts.size() == 1;  // a function without its argument, which may follow
  if (is_alone || is_product(parts, names.functions, is_called)) return parts;
  const Names near = is_called ? near_names(own, names.functions) : Names();
  return {near.empty() ? name : near.front()};
}

Formula_tokens with_known_names(const Formula_tokens& tokens, const Formula_names& names)
{
  Formula_tokens result;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Formula_token& token = tokens[i];
    const bool is_called = i + 1 < tokens.size() && tokens[i + 1].kind == Kind::opening;
    if (token.kind != Kind::name || has(names.values, token.text) ||
        has(names.functions, token.text)) {
      result.push_back(token);
      continue;
    }
    std::string blanks = token.blanks;
    for (const std::string& name : meant_by(token.text, names, is_called))
      result.push_back({Kind::name, name, std::exchange(blanks, "")});
  }
  return result;
}

/// `pow(x, 2)` as x^2
Formula_tokens with_powers(Formula_tokens tokens)
{
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].text != "pow" || tokens[i + 1].kind != Kind::opening) continue;
    const std::size_t end = closing_of(tokens, i + 1);
    std::size_t comma = i + 2;
    for (int depth = 0; comma < end && (depth != 0 || tokens[comma].kind != Kind::comma); ++comma)
      depth += tokens[comma].kind == Kind::opening   ? 1
               : tokens[comma].kind == Kind::closing ? -1
                                                     : 0;
    if (end == tokens.size() || comma >= end) continue;
    const auto argument = [&tokens](std::size_t first, std::size_t last) {
      Formula_tokens part(tokens.begin() + static_cast<std::ptrdiff_t>(first),
                          tokens.begin() + static_cast<std::ptrdiff_t>(last));
      if (!part.empty()) part.front().blanks.clear();
      return part.size() == 1 ? formula_of(part) : '(' + formula_of(part) + ')';
    };
    const std::string power = argument(i + 2, comma) + '^' + argument(comma + 1, end);
    const std::string rest = formula_of(
        Formula_tokens(tokens.begin() + static_cast<std::ptrdiff_t>(end) + 1, tokens.end()));
    tokens.resize(i);
    return with_powers(formula_tokens(formula_of(tokens) + power + rest));
  }
  return tokens;
}

/// `sin x` as sin(x), where that is all that can be meant
Formula_tokens with_arguments(const Formula_tokens& tokens, const Names& functions)
{
  Formula_tokens result;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    result.push_back(tokens[i]);
    if (tokens[i].kind != Kind::name || !has(functions, tokens[i].text)) continue;
    if (i + 1 == tokens.size() || tokens[i + 1].kind == Kind::opening) continue;
    const bool is_last = i + 2 == tokens.size() || tokens[i + 2].text == "+" ||
                         tokens[i + 2].text == "-" || tokens[i + 2].kind == Kind::closing;
    if (!is_last) continue;
    ++i;
    result.push_back({Kind::opening, "("});
    result.push_back({tokens[i].kind, tokens[i].text});
    result.push_back({Kind::closing, ")"});
  }
  return result;
}

/// `2x`, `2 sin(x)`, `x y` and `(x)(y)` as products
Formula_tokens with_products(const Formula_tokens& tokens, const Names& functions)
{
  Formula_tokens result;
  for (const Formula_token& token : tokens) {
    const bool begins =
        token.kind == Kind::number || token.kind == Kind::name || token.kind == Kind::opening;
    const bool ends = !result.empty() &&
                      (result.back().kind == Kind::number || result.back().kind == Kind::closing ||
                       (result.back().kind == Kind::name && !has(functions, result.back().text)));
    const bool is_product = begins && ends;
    if (is_product) result.push_back({Kind::other, "*"});
    result.push_back(token);
    if (is_product) result.back().blanks.clear();
  }
  return result;
}

/// with the parentheses that are missing at the end, and without those that nothing opens
Formula_tokens with_closed_parentheses(const Formula_tokens& tokens)
{
  Formula_tokens result;
  int depth = 0;
  for (const Formula_token& token : tokens) {
    if (token.kind == Kind::closing && depth == 0) continue;
    depth += token.kind == Kind::opening ? 1 : token.kind == Kind::closing ? -1 : 0;
    result.push_back(token);
  }
  for (; depth > 0; --depth) result.push_back({Kind::closing, ")"});
  return result;
}

}  // namespace

std::string corrected_formula(const std::string& text, const Formula_names& names)
{
  Formula_tokens tokens = formula_tokens(with_plain_signs(text));
  if (tokens.empty()) return text;
  tokens = with_closed_parentheses(with_decimal_points(right_side(std::move(tokens))));
  tokens = with_powers(with_known_names(tokens, names));
  Names functions = names.functions;
  functions.emplace_back("pow");  // where it has not two arguments
  tokens = with_products(with_arguments(tokens, functions), functions);
  return formula_of(tokens);
}

}  // namespace conformal
