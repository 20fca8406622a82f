// Tests examples/conformal/process/threads.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"
#include "support/tori.h"

#include "conformal/io/read_surface.h"

#include <set>

namespace cgp_test::threads_tests {

using namespace program_test;

// Large enough that the library uses the threads: a factorization of a millisecond.
class Threads : public Program {
 protected:
  Threads()
  {
    write("ball.off", off(cgp_test::bumpy_sphere(4)));
    write("disk.off", off(cgp_test::disk(28)));
    write("torus.off", off(cgp_test::torus(2, 0.7, 80, 32)));
  }

  std::string output(const std::string& command, int threads) const
  {
    const Program_run r = run(command + " -o out.ply --threads " + std::to_string(threads));
    EXPECT_EQ(r.code, 0) << command << ": " << r.err;
    return content(path("out.ply"));
  }
};

TEST_F(Threads, give_the_same_bytes_again_and_again_and_for_any_number_of_them)
{
  for (const std::string command :
       {"spin ball.off --rho-expression '0.5*sin(4*y)'",
        "spin disk.off --rho-expression x*y --boundary tangents",
        "spin torus.off --rho-expression 0.3*z", "flow ball.off --steps 2",
        "flow disk.off --steps 2 --boundary free", "flatten disk.off", "harmonic torus.off"}) {
    std::set<std::string> outputs;
    for (const int threads : {1, 2, 1, 2, 3}) outputs.insert(output(command, threads));
    EXPECT_EQ(outputs.size(), 1u) << command;
  }
}

// The BLAS adds in another order.
TEST_F(Threads, of_the_blas_change_the_last_digits_at_most)
{
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the BLAS is not compiled with the sanitizer, which sees none of its waits";
#endif
  const std::string command =
      "spin ball.off --rho-expression '0.5*sin(4*y)' --advanced solver=cholmod";
  for (const int threads : {1, 2}) EXPECT_EQ(output(command, threads), output(command, threads));
  const auto points = [&](int threads) {
    return conformal::parse_surface(output(command, threads), "out.ply").points;
  };
  const auto one = points(1), two = points(2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t v = 0; v < one.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(one[v][i], two[v][i], 2e-10);
}

}  // namespace cgp_test::threads_tests
