// Tests examples/conformal/Command_line.cpp
// Tests examples/conformal/run.cpp examples/conformal/process/versions.cpp
// Tests examples/conformal/unknown_argument.cpp examples/conformal/commands/keyed_options.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/spheres.h"

#include <vector>

namespace cgp_test::command_line_tests {

using namespace program_test;

using Command_line = Program;

TEST_F(Command_line, help_of_every_command_has_an_example)
{
  for (const std::string command :
       {"", "info", "spin", "flow", "boundary", "fit", "blend", "harmonic", "compare"}) {
    const Program_run r = run(command + " --help");
    EXPECT_EQ(r.code, 0);
    EXPECT_NE(r.out.find("Example: conformal " + command), std::string::npos) << r.out;
    EXPECT_EQ(r.err, "");
  }
}

TEST_F(Command_line, version_names_the_libraries)
{
  const Program_run r = run("--version");
  EXPECT_EQ(r.code, 0);
  for (const char* name : {"conformal ", "CGAL ", "Eigen 3", "CHOLMOD ", "BLAS "})
    EXPECT_NE(r.out.find(name), std::string::npos) << name;
}

TEST_F(Command_line, nonsense_is_a_usage_error_of_one_line)
{
  EXPECT_TRUE(fails(run(""), 2, "try: conformal --help"));
  EXPECT_TRUE(fails(run("bend a.off"), 2, "unknown command 'bend'"));
  EXPECT_TRUE(fails(run("spin"), 2, "input is required"));
  EXPECT_TRUE(fails(run("spin a.off --rho-expression x"), 2, "--output is required"));
  EXPECT_TRUE(fails(run("spin a.off -o b.ply"), 2, "--rho-expression"));
  EXPECT_TRUE(fails(run("spin a.off -o b.ply --rho-expression x --rho-file y"), 2, "2 were given"));
  EXPECT_TRUE(fails(run("spin --wrong 3 a.off -o b.ply --rho-expression x"), 2, "--wrong"));
  EXPECT_TRUE(fails(run("spin a.off -o b.ply --rho-expression x --threads 0"), 2, "above 0"));
  EXPECT_TRUE(
      fails(run("spin a.off -o b.ply --rho-expression x --limit period_defect=0"), 2, "above 0"));
  EXPECT_TRUE(fails(run("spin a.off -o b.ply --rho-expression x --amplitude inf"), 2, "finite"));
  for (const std::string name : {"a b", "", "$(printf 'a\\nproperty float b')"})
    EXPECT_TRUE(
        fails(run("spin a.off -o b.ply --rho-expression x --lambda \"" + name + '"'), 2, "word"));
  EXPECT_TRUE(
      fails(run("spin a.off -o b.ply --rho-expression x --projection w"), 2, "{uv,x,y,z,sphere}"));
}

TEST_F(Command_line, tells_how_to_build_the_commands_that_were_not)
{
  const std::string small = CGP_PROGRAM_OF_ONE_COMMAND " ";
  EXPECT_TRUE(fails(shell(small + "flow a.off"), 2, "built without 'flow'; try: cmake"));
  EXPECT_TRUE(fails(shell(small + "bend a.off"), 2, "unknown command 'bend'"));
  const Program_run help = shell(small + "--help");
  EXPECT_NE(help.out.find("Built without info"), std::string::npos) << help.out;
  EXPECT_EQ(run("--help").out.find("Built without"), std::string::npos);
  EXPECT_TRUE(shell(small + "spin --help").out == run("spin --help").out);
}

TEST_F(Command_line, unknown_options_are_named_with_those_that_are_near)
{
  const std::string spin = "spin a.off -o b.ply ";
  const std::string advice =
      "unknown option --rho; try: --rho-expression, --rho-property, --rho-file, --rho-image, or "
      "conformal spin --help";
  EXPECT_TRUE(fails(run(spin + "--rho x"), 2, advice));
  EXPECT_TRUE(fails(run(spin + "--rho=x"), 2, advice));
  EXPECT_TRUE(fails(run("spin --rho x a.off -o b.ply"), 2, advice));
  EXPECT_TRUE(
      fails(run("spin a.off --rho-expression x --ouptut b.ply"), 2, "--ouptut; try: --output"));
  EXPECT_TRUE(fails(run("spin a.off --rho-expression x -x b.ply"), 2, "option -x; try: conformal"));
  EXPECT_TRUE(
      fails(run("flow a.off -o b.ply --rho-file x"), 2, "--rho-file, which is one of spin"));
  EXPECT_TRUE(fails(run("spin --hlep"), 2, "--hlep; try: --help, or conformal spin --help"));
  EXPECT_TRUE(fails(run("--rho x"), 2, "unknown option --rho"));
  EXPECT_TRUE(fails(run("--versoin"), 2, "unknown option --versoin; try: --version, or conformal"));
  EXPECT_TRUE(fails(run("--rho x spin"), 2, "--rho is before the name of a command"));
}

TEST_F(Command_line, options_that_have_become_keys_are_named_as_such)
{
  for (const auto& [before, now] : {std::pair{"--max-closure=1", "--limit closure=VALUE"},
                                    {"--min-realised=1", "--limit realised_share=VALUE"},
                                    {"--max-period-defect=1", "--limit period_defect=VALUE"},
                                    {"--seed=1", "--advanced seed=VALUE"},
                                    {"--strict", "--advanced strict"}})
    EXPECT_TRUE(fails(run(std::string("spin a.off ") + before), 2, std::string("; try: ") + now));
}

TEST_F(Command_line, keys_are_checked_reported_and_listed)
{
  write("a.off", off(cgp_test::icosphere(1)));
  const std::string spin = "spin -q a.off -o b.ply --rho-expression x --json b.json ";
  ASSERT_EQ(run(spin + "--advanced seed=3 --limit closure=.2 --advanced ascii").code, 0);
  const auto options = read_json("b.json")["options"];
  EXPECT_EQ(options["seed"], "3");
  EXPECT_EQ(options["closure"], ".2");
  EXPECT_EQ(options["ascii"], true);
  EXPECT_EQ(options["flipped_share"], "0.01");
  EXPECT_TRUE(fails(run(spin + "--limit closre=1"), 2, "unknown key 'closre'; try: closure, or "));
  EXPECT_TRUE(fails(run(spin + "--advanced seed=x"), 2, "--seed"));
  EXPECT_TRUE(fails(run(spin + "--advanced seed"), 2, "--seed"));
  const Program_run list = run("spin --limit help");
  EXPECT_EQ(list.code, 0);
  EXPECT_NE(list.out.find("\n    flipped_share FLOAT=0.01 "), std::string::npos) << list.out;
}

TEST_F(Command_line, unknown_arguments_and_commands_are_named)
{
  EXPECT_TRUE(fails(run("spin a.off -o b.ply --rho-expression 2 + x"), 2,
                    "unexpected argument '+'; try: quotes around"));
  EXPECT_TRUE(fails(run("spn a.off"), 2, "unknown command 'spn'; try: spin, or --help"));
  EXPECT_TRUE(fails(run("x"), 2, "unknown command 'x'; try: info, spin, "));
}

TEST_F(Command_line, numbers_that_no_work_could_use_are_usage_errors)
{
  const std::string spin = "spin a.off -o b.ply --rho-expression x ";
  for (const std::string number : {"nan", "inf", "1e300"}) {
    for (const std::string option :
         {"--amplitude ",
          "--advanced tolerance=", "--limit closure=", "--limit quasi_conformal=", "--max-scale ",
          "--advanced max-memory=", "--filter low-pass --filter-weight ", "--mollify="})
      EXPECT_EQ(run(spin + option + number).code, 2) << option << number;
    EXPECT_EQ(run("spectrum a.off --advanced resolution=" + number).code, 2) << number;
    EXPECT_EQ(run("spectrum a.off --shift " + number).code, 2) << number;
    EXPECT_EQ(run("boundary a.off -o b.ply --minimal --position-weight " + number).code, 2);
    EXPECT_EQ(run("curve a.svg -o b.svg --animate --seconds " + number).code, 2) << number;
  }
  EXPECT_EQ(run(spin + "--advanced tolerance=1").code, 2);
  for (const std::string kappa : {"2000000000", "-2000000000", "1001"})
    EXPECT_EQ(run("sphere -o b.ply --kappa " + kappa).code, 2) << kappa;
}

TEST_F(Command_line, unreadable_files_are_named_with_the_reason)
{
  write("empty.off", "");
  write("page.obj", "<!DOCTYPE html><html></html>");
  write("points.ply",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
        "property float z\nend_header\n0 0 0\n");
  write("claims.off", "OFF\n2000000000 1 0\n0 0 0\n");
  write("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  write("nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n");
  for (const std::string name : {"absent.off", ".", "empty.off", "page.obj", "points.ply",
                                 "claims.off", "index.off", "nan.off"})
    EXPECT_TRUE(fails(run("info " + name), 3, name)) << name;
}

TEST_F(Command_line, outputs_that_cannot_be_written_are_refused_and_leave_nothing)
{
  write("a.off", off(cgp_test::icosphere(1)));
  const std::string spin = "spin a.off --rho-expression x -o ";
  EXPECT_TRUE(fails(run(spin + "b.xyz"), 5, "b.xyz"));
  EXPECT_TRUE(fails(run(spin + "b"), 5, "extension"));
  EXPECT_TRUE(fails(run(spin + "absent/b.ply"), 5, "absent/b.ply"));
  EXPECT_TRUE(fails(run(spin + "b.ply --json absent/b.json"), 5, "absent/b.json"));
  EXPECT_TRUE(fails(run(spin + "b.ply --json b.ply"), 2, "the same file, b.ply"));
  EXPECT_FALSE(has("b.ply"));
  std::filesystem::create_symlink("/dev/full", path("full.ply"));
  EXPECT_TRUE(fails(run(spin + "full.ply -q"), 5, "full.ply"));
  EXPECT_EQ(temporary_files(), 0u);
  EXPECT_EQ(shell(program() + " info a.off >/dev/full").code, 5);
}

// A sphere with vertices so near to edges that its Laplacian cannot be factorized.
std::string with_slivers()
{
  const auto mesh = cgp_test::icosphere(3);
  auto points = mesh.positions();
  auto corners = mesh.corners();
  std::vector<char> is_used(static_cast<std::size_t>(mesh.size_of_vertices()));
  for (std::size_t f = 0; f < mesh.corners().size(); ++f) {
    const auto all = corners[f];
    const auto used = [&](int v) -> char& { return is_used[static_cast<std::size_t>(v)]; };
    if (used(all[0]) || used(all[1]) || used(all[2])) continue;
    for (const int i : all) used(i) = 1;
    const int v = static_cast<int>(points.cols());
    const auto [a, b, c] = all;
    points.conservativeResize(3, v + 1);
    points.col(v) = (points.col(a) + points.col(b)) * (0.5 - 5e-12) + 1e-11 * points.col(c);
    corners[f] = {a, b, v};
    corners.push_back({b, c, v});
    corners.push_back({c, a, v});
  }
  return off({points, corners});
}

TEST_F(Command_line, errors_of_the_solver_name_the_file)
{
  write("a.off", with_slivers());
  EXPECT_TRUE(fails(run("spin a.off --rho-expression '0.7*sin(4*y)' --mollify=0 --max-scale none "
                        "-o b.ply"),
                    1, "error: a.off: the eigenvector did not converge"));
}

TEST_F(Command_line, repair_takes_faces_that_have_a_corner_twice)
{
  std::string text = off(cgp_test::icosahedron()) + "3 0 0 1\n";
  text.replace(text.find("20 0"), 4, "21 0");
  write("a.off", text);
  EXPECT_TRUE(fails(run("info a.off"), 3, "twice, wanted different corners; try: --repair"));
  const Program_run r = run("info a.off --repair");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.err.find("1 face removed"), std::string::npos) << r.err;
}

TEST_F(Command_line, names_in_a_file_cannot_steer_the_terminal)
{
  const std::string name = "\x1b[31m\xc2\x9b\xc3\xa9";  // two ways to begin a colour, and a letter
  const std::string vertices = "0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
  write("a.ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty float " +
            name + "\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n" +
            vertices + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const Program_run noted = run("split a.ply -o b.off");
  EXPECT_EQ(noted.code, 0);
  EXPECT_NE(noted.err.find("property \\x1b[31m\\xc2\\x9b\xc3\xa9 is not"), std::string::npos)
      << noted.err;
  EXPECT_TRUE(fails(run("spin a.ply --rho-property none -o b.ply"), 4, "\\x1b[31m"));
}

TEST_F(Command_line, standard_input_and_odd_names_are_read)
{
  write("a b \xc3\xa9.off", off(cgp_test::icosahedron()));
  EXPECT_EQ(run("info 'a b \xc3\xa9.off'").code, 0);
  EXPECT_EQ(run("info - < 'a b \xc3\xa9.off'").code, 0);
}

TEST_F(Command_line, numbers_do_not_follow_the_locale)
{
  write("a.off", off(cgp_test::icosphere(1)));
  const std::string c = run("info a.off").out;
  EXPECT_EQ(shell("LC_ALL=de_DE.UTF-8 " + program() + " info a.off").out, c);
}

TEST_F(Command_line, signals_end_the_program_without_a_trace)
{
  write("a.off", off(cgp_test::bumpy_sphere(6)));
  for (const auto& [signal, code] :
       {std::pair("INT", 130), std::pair("TERM", 143), std::pair("HUP", 129),
        std::pair("XCPU", 152), std::pair("KILL", 137)}) {
    // A fifo holds the program back until the signal has come.
    const Program_run r =
        shell("rm -f in b.ply; mkfifo in; exec 3<>in; " + program() +
              " spin - --rho-expression x -o b.ply --json b.json <in & sleep 0.3; kill -" +
              std::string(signal) + " $!; wait $!");
    EXPECT_EQ(r.code, code) << signal << r.err;
    const std::string told = code == 137 ? "" : "error: interrupted; nothing was written\n";
    EXPECT_NE(r.err.find(told), std::string::npos) << r.err;
    EXPECT_FALSE(has("b.ply"));
    EXPECT_EQ(temporary_files(), 0u);
  }
}

TEST_F(Command_line, a_limit_on_the_size_of_files_is_a_write_error)
{
  // Not too small for the counts of executed lines, which an instrumented program writes.
  write("a.off", off(cgp_test::icosphere(5)));
  const Program_run r =
      shell("ulimit -f 512; " + program() + " spin -q a.off --rho-expression x -o b.ply");
  EXPECT_TRUE(fails(r, 5, "b.ply"));
  EXPECT_EQ(temporary_files(), 0u);
}

}  // namespace cgp_test::command_line_tests
