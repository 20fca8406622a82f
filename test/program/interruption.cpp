// Tests examples/conformal/process/interruption.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/spheres.h"

namespace cgp_test::interruption_tests {

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
  // A fifo is open for writing once the program reads it, which it does until its end.
  const Program_run r = shell("mkfifo in.off; " + program() +
                              " info in.off & exec 3>in.off; kill -INT $!; kill -TERM $!; wait $!");
  expect_told(r, "interrupted; nothing was written");
}

TEST_F(Interruption, tells_what_was_written)
{
  write("a.off", off(cgp_test::bumpy_sphere(4)));
  const std::string flow = "flow -q a.off --steps 100000 --time-step .001 --every 1 -o ";
  expect_told(interrupted_after("b_0001.ply", flow + "b.ply"), "interrupted; b_0001.ply");
  expect_told(interrupted_after("c_0005.ply", flow + "c.ply"),
              " files were written, the last is c_0");
  EXPECT_FALSE(has("b.ply") || has("c.ply"));
  EXPECT_EQ(temporary_files(), 0u);
}

}  // namespace cgp_test::interruption_tests
