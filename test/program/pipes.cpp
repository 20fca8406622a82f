// Tests examples/conformal/run.cpp examples/conformal/io/file/Temporary_file.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "program/support.h"
#include "support/spheres.h"

namespace cgp_test::pipes_tests {

using namespace program_test;

/// standard output is a pipe whose reader has ended, as `head` may
class Closed_pipe : public Program {
 protected:
  Closed_pipe() { write("a.off", off(cgp_test::icosphere(1))); }

  Program_run into_closed_pipe(const std::string& arguments) const
  {
    const Program_run r =
        shell("{ sleep .05; " + program() + ' ' + arguments + "; echo $? >code.txt; } | true");
    return {std::stoi(content(path("code.txt"))), r.out, r.err};
  }
};

TEST_F(Closed_pipe, ends_the_output_quietly)
{
  for (const std::string command :
       {"info a.off", "--version", "spin --help", "info a.off -q --json /dev/stdout"}) {
    const Program_run r = into_closed_pipe(command);
    EXPECT_EQ(r.code, 0) << command;
    EXPECT_EQ(r.err, "") << command;
  }
}

TEST_F(Closed_pipe, does_not_take_the_other_outputs_away)
{
  const Program_run r = into_closed_pipe(
      "spectrum a.off --count 2 --csv /dev/stdout --surface 0 -o b.ply "
      "--json b.json");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_TRUE(has("b.ply"));
  EXPECT_EQ(read_json("b.json")["command"], "spectrum");
}

TEST_F(Closed_pipe, does_not_hide_another_error)
{
  EXPECT_TRUE(fails(into_closed_pipe("spin a.off --rho-expression 'sin(' -o b.ply"), 2, "sin("));
  EXPECT_TRUE(fails(into_closed_pipe("info absent.off"), 3, "absent.off"));
}

TEST_F(Closed_pipe, is_an_error_where_it_is_the_output_that_was_named)
{
  write("a.off", off(cgp_test::icosphere(5)));
  const Program_run r = shell("mkfifo b.ply; { head -c 9 b.ply >c.txt & }; " + program() +
                              " spin -q a.off --rho-expression x -o b.ply");
  EXPECT_TRUE(fails(r, 5, "b.ply: cannot be written"));
}

TEST_F(Closed_pipe, closed_streams_are_no_place_for_files)
{
  const std::string spin = program() + " spin a.off --rho-expression x --advanced progress=json ";
  EXPECT_EQ(shell(spin + "-o b.ply --json b.json >&- 2>&-").code, 0);
  EXPECT_EQ(read_json("b.json")["command"], "spin");
}

}  // namespace cgp_test::pipes_tests
