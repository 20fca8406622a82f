// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Expression.h"

#include "Failure.h"

#include <muParser.h>

#include <array>
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

Failure bad(const std::string& text, const std::string& message)
{
  return {Exit_code::usage, "--rho-expression '" + text + "': " + message +
                                "; try: a formula in x, y, z, nx, ny, nz such as sin(5*y)"};
}

}  // namespace

struct Expression::Parser {
  explicit Parser(const std::string& t) : text(t)
  {
    const std::array names = {"x", "y", "z", "nx", "ny", "nz"};
    for (std::size_t i = 0; i < names.size(); ++i) parser.DefineVar(names[i], &values[i]);
    parser.DefineConst("pi", std::acos(-1.));
    parser.DefineConst("e", std::exp(1.));
    parser.DefineFun("gauss", gauss);
    parser.DefineFun("bump", bump);
    parser.SetExpr(text);
  }

  double value()
  {
    try {
      int results = 0;
      const double* all = parser.Eval(results);
      if (results != 1) throw bad(text, "gives " + std::to_string(results) + " values, wanted one");
      return all[0];
    } catch (const mu::Parser::exception_type& error) {
      // muParser counts from 0, and says so in most of its messages, but not in all.
      const std::string message = error.GetMsg();
      throw bad(text, message.substr(0, message.find(" at position")) + ", at place " +
                          std::to_string(error.GetPos() + 1));
    }
  }

  std::string text;
  std::array<double, 6> values{};
  mu::Parser parser;
};

Expression::Expression(const std::string& text) : m_parser(std::make_unique<Parser>(text))
{
  m_parser->value();
}

Expression::~Expression() = default;

double Expression::operator()(const Eigen::Vector3d& point, const Eigen::Vector3d& normal)
{
  for (Eigen::Index i = 0; i < 3; ++i) {
    m_parser->values[static_cast<std::size_t>(i)] = point[i];
    m_parser->values[static_cast<std::size_t>(i + 3)] = normal[i];
  }
  return m_parser->value();
}

}  // namespace conformal
