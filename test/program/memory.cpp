// Tests examples/conformal/process/memory.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"
#include "support/spheres.h"
#include "support/tori.h"

#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <sys/resource.h>

#include <string>

namespace cgp_test::memory_tests {

using namespace program_test;

using Memory = Program;

TEST_F(Memory, has_a_limit_beyond_which_the_work_ends_with_a_reason)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers reserve more for themselves";
#endif
  write("a.off", off(cgp_test::icosphere(6)));
  const std::string spin = "spin -q a.off --rho-expression z -o b.ply ";
  EXPECT_TRUE(fails(run(spin + "--advanced max-memory=.1"), 6, "out of memory: more than 0.1 GiB"));
  EXPECT_FALSE(has("b.ply"));
  EXPECT_EQ(run(spin + "--advanced max-memory=.01").code, 2);
}

double size_of_mesh_and_factor(const cgp_test::Mesh_view& mesh)
{
  namespace CGP = Conformal_geometry_processing;
  CGP::Supernodal_cholesky<CGP::Quaternion<double>> solver;
  EXPECT_EQ(solver.analyze(*CGP::vertex_graph(mesh)), CGP::Solver_status::success);
  return 24. * mesh.size_of_vertices() + 12. * mesh.size_of_faces() + solver.statistics().bytes;
}

TEST_F(Memory, of_commands_is_at_most_ten_times_that_of_the_mesh_and_its_factor)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more";
#endif
  const auto mesh = cgp_test::icosphere(5);
  write("a.off", off(mesh));
  for (const std::string command :
       {"spin a.off --rho-expression x*y", "flow a.off --steps 1", "blend a.off a.off"})
    EXPECT_EQ(run(command + " -q -o b.ply").code, 0) << command;
  rusage usage{};
  ASSERT_EQ(::getrusage(RUSAGE_CHILDREN, &usage), 0);
  const double kibibyte = 1024;
  EXPECT_LT(kibibyte * static_cast<double>(usage.ru_maxrss), 10 * size_of_mesh_and_factor(mesh));
}

/// Threads may have no more. Temporaries of dense products and orderings do not fit.
TEST_F(Memory, of_the_stack_is_less_than_128_kilobytes)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more";
#endif
  write("a.off", off(cgp_test::torus(2, 1, 80, 40)));
  for (const std::string command : {"spin a.off --rho-expression x/9", "flow a.off --steps 2"})
    EXPECT_EQ(shell("ulimit -s 128; " + program() + " " + command + " -q -o b.ply").code, 0)
        << command;
}

}  // namespace cgp_test::memory_tests
