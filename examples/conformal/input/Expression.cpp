// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Expression.h"

#include "corrected_formula.h"

#include "conformal/io/file/numbers.h"
#include "conformal/process/Failure.h"
#include "conformal/process/near_names.h"

#include <muParser.h>

#include <algorithm>
#include <cmath>

namespace conformal {
namespace {

double gauss(double d, double s)
{
  return std::exp(-d * d / (2 * s * s));
}

double bump(double d, double r)
{
  const double t = d / r;
  return t * t < 1 ? std::exp(1 - 1 / (1 - t * t)) : 0;
}

// muParser has constants of its own that begin with a low line.
template <class Map>
std::vector<std::string> names_in(const Map& map)
{
  std::vector<std::string> names;
  for (const auto& entry : map)
    if (entry.first[0] != '_') names.push_back(entry.first);
  return names;
}

/// where a variable is assigned to, which muParser allows; npos if nowhere
std::size_t assignment_in(const std::string& text)
{
  const std::string comparisons = "<>!=";  // begin like this and end with =
  for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1)) {
    const bool ends = i > 0 && comparisons.find(text[i - 1]) != std::string::npos;
    const bool begins = i + 1 < text.size() && text[i + 1] == '=';
    if (!ends && !begins) return i;
  }
  return std::string::npos;
}

}  // namespace

struct Expression::Parser {
  Parser(const std::string& t, const std::string& o, const std::vector<std::string>& more)
      : text(t), option(o)
  {
    names.insert(names.end(), more.begin(), more.end());
    values.resize(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) parser.DefineVar(names[i], &values[i]);
    parser.DefineConst("pi", std::acos(-1.));
    parser.DefineConst("e", std::exp(1.));
    parser.DefineFun("gauss", gauss);
    parser.DefineFun("bump", bump);
    if (const std::size_t i = assignment_in(text); i != std::string::npos)
      throw bad("an assignment, at place " + std::to_string(i + 1));
    try {
      parser.SetExpr(text);  // finds no other fault than this
    } catch (const mu::Parser::exception_type&) {
      throw bad("is too long with its " + std::to_string(text.size()) + " characters");
    }
  }

  double value()
  {
    try {
      int results = 0;
      const double* all = parser.Eval(results);
      if (results != 1) throw bad("gives " + std::to_string(results) + " values, wanted one");
      return all[0];
    } catch (const mu::Parser::exception_type& error) {
      // muParser counts from 0, and says so in most of its messages, but not in all.
      // It reads a blank after the end, and has no place where a condition lacks its second case.
      const std::string message = error.GetMsg();
      const auto place = static_cast<std::size_t>(error.GetPos()) + 1;
      throw bad(
          message.substr(0, message.find(" at position")) +
          (place == 0 ? "" : ", at place " + std::to_string(std::min(place, text.size() + 1))));
    }
  }

  Failure bad(const std::string& message) const
  {
    const std::vector<std::string> constants = names_in(parser.GetConst());
    Formula_names known{names, names_in(parser.GetFunDef())};
    known.values.insert(known.values.end(), constants.begin(), constants.end());
    const std::string meant = corrected_formula(text, known);
    const bool is_better = meant != text && is_formula(meant);
    return {Exit_code::usage,
            option + " " + in_quotes(text) + ": " + message +
                "; try: " + (is_better ? "'" + meant + "'" : "a formula such as sin(5*y)") +
                "; there are the variables " + listed(names) + ", the constants " +
                listed(constants) + ", the operators + - * / ^, and the functions " +
                listed(known.functions)};
  }

  bool is_formula(const std::string& other) const
  {
    try {
      mu::Parser another = parser;
      another.SetExpr(other);
      int results = 0;
      another.Eval(results);
      return results == 1 && assignment_in(other) == std::string::npos;
    } catch (const mu::Parser::exception_type&) {
      return false;
    }
  }

  std::string text, option;
  std::vector<std::string> names = {"x", "y", "z", "nx", "ny", "nz"};
  std::vector<double> values;
  mu::Parser parser;
};

Expression::Expression(const std::string& text, const std::string& option,
                       const std::vector<std::string>& more)
    : m_parser(std::make_unique<Parser>(text, option, more))
{
  m_parser->value();
}

Expression::~Expression() = default;

double Expression::operator()(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                              const std::vector<double>& more)
{
  std::vector<double>& values = m_parser->values;
  for (Eigen::Index i = 0; i < 3; ++i) {
    values[static_cast<std::size_t>(i)] = point[i];
    values[static_cast<std::size_t>(i + 3)] = normal[i];
  }
  std::copy(more.begin(), more.end(), values.begin() + 6);
  return m_parser->value();
}

}  // namespace conformal
