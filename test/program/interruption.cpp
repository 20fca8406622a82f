// Tests examples/conformal/process/interruption.cpp
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/spheres.h"

namespace {

using namespace program_test;

/// runs the program until a file is there, and then ends it by two signals
class Interruption : public Program {
 protected:
  Program_run interrupted_after(const std::string& file, const std::string& arguments) const
  {
    return shell(program() + ' ' + arguments + " & while [ ! -e " + file +
                 " ]; do sleep .01; done; kill -INT $!; kill -TERM $!; wait $!");
  }

  /// the handler of which of the two runs first is not known
  static void expect_told(const Program_run& r, const std::string& words)
  {
    EXPECT_TRUE(fails(r, r.code == 143 ? 143 : 130, words));
  }
};

TEST_F(Interruption, tells_that_nothing_was_written)
{
  // The program waits for the end of its input.
  const Program_run r = shell("mkfifo in; exec 3<>in; " + program() +
                              " info - <in & sleep .1; kill -INT $!; sleep .02; kill -INT $!; "
                              "wait $!");
  EXPECT_TRUE(fails(r, 130, "interrupted; nothing was written"));
}

TEST_F(Interruption, tells_what_was_written)
{
  write("a.off", off(cgp_test::bumpy_sphere(4)));
  const std::string flow = "flow -q a.off --steps 100000 --time-step .001 -o b.ply --every ";
  expect_told(interrupted_after("b_0001.ply", flow + "1"), "interrupted; b_0001.ply");
  expect_told(interrupted_after("b_0005.ply", flow + "1"), " files were written, the last is b_0");
  EXPECT_FALSE(has("b.ply"));
  EXPECT_EQ(temporary_files(), 0u);
}

}  // namespace
