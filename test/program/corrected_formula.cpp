// Tests examples/conformal/input/corrected_formula.cpp examples/conformal/input/formula_tokens.cpp
// Tests examples/conformal/input/Expression.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/input/corrected_formula.h"

#include "program/support.h"
#include "support/spheres.h"

#include "conformal/input/Expression.h"
#include "conformal/process/Failure.h"

#include <string>
#include <utility>

namespace cgp_test::corrected_formula_tests {

using namespace program_test;

const conformal::Formula_names names = {{"x", "y", "nx", "pi", "e"}, {"sin", "asin", "sqrt"}};

std::string corrected(const std::string& text)
{
  return conformal::corrected_formula(text, names);
}

TEST(Corrected_formula, has_products_and_powers_in_the_notation_of_the_parser)
{
  for (const auto& [wrong, right] :
       {std::pair("x**2", "x^2"), std::pair("2x", "2*x"), std::pair("2 sin(x)", "2*sin(x)"),
        std::pair("(x)(y)", "(x)*(y)"), std::pair("x(y+1)", "x*(y+1)"), std::pair("x y", "x*y"),
        std::pair("2pi x", "2*pi*x"), std::pair("2.5e-3x", "2.5e-3*x"), std::pair("2e", "2*e"),
        std::pair("xy", "x*y"), std::pair("2nxy", "2*nx*y"), std::pair("sin(x)y", "sin(x)*y"),
        std::pair("pow(x, 2)", "x^2"), std::pair("1+pow(x+1, pow(y,2))*3", "1+(x+1)^(y^2)*3")})
    EXPECT_EQ(corrected(wrong), right) << wrong;
}

TEST(Corrected_formula, has_known_names_and_plain_signs)
{
  for (const auto& [wrong, right] :
       {std::pair("Sin(X)", "sin(x)"), std::pair("sine(x)", "sin(x)"),
        std::pair("np.sin(x)", "sin(x)"), std::pair("arcsin(x)", "asin(x)"),
        std::pair("2xsin(x)", "2*x*sin(x)"), std::pair("\"x;\"", "x"),
        std::pair("sin x + 1", "sin(x) + 1"), std::pair("sinx", "sin(x)"),
        std::pair("x\xc2\xb2", "x^2"), std::pair("2\xc3\x97x", "2*x"),
        std::pair("\xcf\x80x", "pi*x"), std::pair("[x]", "(x)")})
    EXPECT_EQ(corrected(wrong), right) << wrong;
}

TEST(Corrected_formula, has_closed_parentheses_decimal_points_and_no_left_side)
{
  for (const auto& [wrong, right] :
       {std::pair("sin(2*(x", "sin(2*(x))"), std::pair("sin(x))", "sin(x)"),
        std::pair("1,5*x", "1.5*x"), std::pair("rho = x", "x"), std::pair("f(x, y) = x*y", "x*y")})
    EXPECT_EQ(corrected(wrong), right) << wrong;
}

TEST(Corrected_formula, is_the_text_where_nothing_is_recognised)
{
  for (const std::string text :
       {"", "foo", "x+", "sin(5*y)", "sin x*y", "x == 2", "pow(x)", "pow", "x2", "sin(1,5)", "= x"})
    EXPECT_EQ(corrected(text), text);
  const std::string many(20000, 'x');  // which would take minutes to be taken apart
  EXPECT_EQ(corrected(many), many);
}

std::string message_of(const std::string& formula, const std::vector<std::string>& more = {})
{
  try {
    conformal::Expression(formula, "--rho-expression", more);
  } catch (const conformal::Failure& failure) {
    return failure.what();
  }
  return "";
}

TEST(Corrected_formula_of_an_expression, that_is_no_formula_tells_the_one_that_may_be_meant)
{
  EXPECT_NE(message_of("x**2").find("; try: 'x^2'; there are"), std::string::npos);
  EXPECT_NE(message_of("2x").find("; try: '2*x'; there are"), std::string::npos);
  EXPECT_NE(message_of("2s", {"s"}).find("; try: '2*s'; there are"), std::string::npos);
  EXPECT_NE(message_of("rho=2x").find("; try: '2*x'; there are"), std::string::npos);
  EXPECT_NE(message_of("1,5*x").find("; try: '1.5*x'; there are"), std::string::npos);
  const std::string sum = "1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+";
  EXPECT_NE(message_of(sum + "2x").find("try: '" + sum + "2*x'"), std::string::npos);
}

// What would be no formula either is not said.
TEST(Corrected_formula_of_an_expression, that_is_no_formula_tells_what_there_is)
{
  for (const char* other : {"cot(x)", "log1p(x)", "int(x)", "exp2(x)"})
    EXPECT_EQ(message_of(other).find("; try: '"), std::string::npos) << other;
  for (const std::string wrong : {"foo(x)", "2x+", "x+foo", "sin(2x"}) {
    const std::string message = message_of(wrong, {"loop"});
    const bool is_said = wrong == "sin(2x";
    EXPECT_EQ(message.find("try: a formula such as sin(5*y)") == std::string::npos, is_said)
        << message;
    for (const std::string part :
         {"variables x, y, z, nx, ny, nz, loop, ", "constants e, pi,", "bump, ", "gauss, ", "sqrt"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find("_pi"), std::string::npos) << message;
  }
}

using Formula = Program;

TEST_F(Formula, of_every_option_is_corrected)
{
  write("a.off", off(cgp_test::icosphere(1)));
  const std::string spin = "spin -q a.off -o b.ply --rho-expression ";
  EXPECT_TRUE(fails(run(spin + "'x**2'"), 2, "--rho-expression 'x**2': "));
  EXPECT_TRUE(fails(run(spin + "2x"), 2, "try: '2*x'"));
  EXPECT_TRUE(fails(run(spin + "x --target-scale-expression '2 + 2x'"), 2, "try: '2 + 2*x'"));
}

}  // namespace cgp_test::corrected_formula_tests
