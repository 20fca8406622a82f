// Tests examples/conformal/output_names.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/spheres.h"

namespace cgp_test::output_names_tests {

using namespace program_test;

/// with a mesh a.off and other inputs, none of which may change
class Output_names : public Program {
 protected:
  Output_names()
  {
    for (const char* name : {"a.off", "b.off", "c.off"}) write(name, off(cgp_test::icosphere(1)));
    write("rho.ply", "0\n");
    write("picture.html", "P5\n");
  }

  ::testing::AssertionResult refuses(const std::string& arguments, const std::string& words)
  {
    const std::string before = all();
    const auto result = fails(run(arguments), 2, words);
    if (result && all() != before)
      return ::testing::AssertionFailure() << "an input is another one now: " << arguments;
    return result;
  }

 private:
  std::string all() const
  {
    std::string text;
    for (const char* name : {"a.off", "b.off", "c.off", "rho.ply", "picture.html"})
      text += cgp_test::content(path(name));
    return text;
  }
};

TEST_F(Output_names, reports_are_not_written_over_inputs)
{
  EXPECT_TRUE(refuses("info a.off --json a.off",
                      "--json and the input name the same file, a.off; try: another name"));
  EXPECT_TRUE(refuses("info - --json a.off < a.off", "--json and the input"));
  const std::string spin = "spin a.off -o d.ply ";
  EXPECT_TRUE(refuses(spin + "--rho-expression x --json a.off", "--json and the input"));
  EXPECT_TRUE(refuses(spin + "--rho-expression x --html a.off", "--html and the input"));
  EXPECT_TRUE(refuses(spin + "--rho-file rho.ply --json rho.ply", "--json and --rho-file"));
  EXPECT_TRUE(refuses(spin + "--paint picture.html --html picture.html", "--html and --paint"));
  EXPECT_TRUE(refuses("compare a.off b.off --json b.off", "--json and the mesh after"));
  EXPECT_TRUE(refuses("fit a.off b.off -o d.ply --json b.off", "--json and the target"));
  EXPECT_TRUE(refuses("spectrum a.off --csv a.off", "--csv and the input"));
  EXPECT_TRUE(refuses("curve a.off -o d.csv --json a.off", "--json and the input"));
  EXPECT_FALSE(has("d.ply"));
}

TEST_F(Output_names, the_result_is_written_over_no_other_input)
{
  EXPECT_TRUE(refuses("spin a.off --rho-file rho.ply -o rho.ply", "--output and --rho-file"));
  EXPECT_TRUE(refuses("fit a.off b.off -o b.off", "--output and the target"));
  EXPECT_TRUE(refuses("blend a.off b.off -o b.off", "--output and the mesh B"));
  EXPECT_TRUE(refuses("blend a.off b.off --onto c.off -o a.off", "--output and the mesh A"));
  EXPECT_TRUE(refuses("compare a.off b.off -o a.off", "--output and the mesh before"));
  for (const std::string option :
       {"--tangents-from", "--binormals-from", "--positions-from", "--curve"})
    EXPECT_TRUE(refuses("boundary a.off -o c.off " + option + " c.off", "--output and " + option));
}

TEST_F(Output_names, a_file_is_known_by_all_its_names)
{
  std::filesystem::create_symlink("a.off", path("link"));
  std::filesystem::create_directory(path("folder"));
  EXPECT_TRUE(refuses("info link --json a.off", "the same file, a.off"));
  EXPECT_TRUE(refuses("info a.off --json link", "the same file, link"));
  EXPECT_TRUE(refuses("info a.off --json folder/.././a.off", "the same file"));
  EXPECT_TRUE(refuses("info a.off --json '" + path("a.off") + "'", "the same file"));
}

TEST_F(Output_names, two_outputs_do_not_replace_each_other)
{
  const std::string spin = "spin a.off --rho-expression x -o d.ply ";
  EXPECT_TRUE(refuses(spin + "--json d.ply", "--json and --output name the same file, d.ply"));
  EXPECT_TRUE(refuses(spin + "--json folder/../d.ply", "--json and --output"));
  EXPECT_TRUE(refuses(spin + "--json d.html --html ./d.html", "--html and --json"));
  EXPECT_TRUE(refuses("spectrum a.off --json d --csv d", "--csv and --json"));
  EXPECT_FALSE(has("d.ply"));
  EXPECT_EQ(run("spectrum a.off --count 1 -q --json /dev/null --csv /dev/null").code, 0);
}

TEST_F(Output_names, the_result_may_replace_what_it_is_made_of)
{
  EXPECT_EQ(run("spin a.off --rho-expression x -o a.off -q").code, 0);
  EXPECT_NE(cgp_test::content(path("a.off")), cgp_test::content(path("b.off")));
  EXPECT_EQ(run("blend a.off b.off --onto c.off -o ./c.off -q").code, 0);
  EXPECT_EQ(run("compare a.off c.off -o c.off -q").code, 0);
}

TEST_F(Output_names, an_output_has_a_name)
{
  for (const std::string option : {"--json", "--html"})
    for (const std::string name : {"-", "''"})
      EXPECT_TRUE(refuses("spin a.off --rho-expression x -o d.ply " + option + ' ' + name,
                          option + ": wanted the name of a file"));
  EXPECT_TRUE(refuses("spectrum a.off --csv -", "--csv: wanted the name of a file"));
  EXPECT_TRUE(refuses("harmonic a.off -o -", "--output: wanted the name of a file"));
  EXPECT_FALSE(has("-"));
  EXPECT_EQ(run("harmonic a.off -o ''").err.find("/dev/stdout"), std::string::npos);
  const Program_run piped = run("info a.off -q --json /dev/stdout | cat");
  EXPECT_EQ(piped.out.substr(0, 1), "{") << piped.err;
}

}  // namespace cgp_test::output_names_tests
