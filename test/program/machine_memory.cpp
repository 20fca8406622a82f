// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests examples/conformal/process/machine_memory.cpp
#include "program/support.h"

#include "conformal/process/machine_memory.h"

#include <cmath>

namespace cgp_test::machine_memory_tests {

using namespace program_test;

// Files of a made up system, with which /proc and /sys are replaced.
class Machine_memory : public Program {
 protected:
  void put(const std::string& file, const std::string& text) const
  {
    std::filesystem::create_directories(std::filesystem::path(path(file)).parent_path());
    write(file, text);
  }

  double memory() const { return conformal::memory_of_control_groups(path("")); }
};

TEST_F(Machine_memory, has_no_limit_without_groups)
{
  EXPECT_EQ(memory(), HUGE_VAL);
  put("proc/self/cgroup", "0::/\n");
  EXPECT_EQ(memory(), HUGE_VAL);
  put("sys/fs/cgroup/memory.max", "max\n");
  EXPECT_EQ(memory(), HUGE_VAL);
}

TEST_F(Machine_memory, is_the_least_of_nested_groups_of_version_2)
{
  put("proc/self/cgroup", "0::/machine/of me/job\n");
  put("sys/fs/cgroup/machine/of me/job/memory.max", "max\n");
  put("sys/fs/cgroup/machine/of me/memory.max", "3000000000\n");
  put("sys/fs/cgroup/machine/memory.max", "5000000000\n");
  EXPECT_EQ(memory(), 3e9);
  put("sys/fs/cgroup/machine/memory.max", "2000000000\n");
  EXPECT_EQ(memory(), 2e9);
  put("sys/fs/cgroup/machine/of me/job/memory.max", "1000000000\n");
  EXPECT_EQ(memory(), 1e9);
  put("sys/fs/cgroup/other/memory.max", "1\n");
  EXPECT_EQ(memory(), 1e9);
}

TEST_F(Machine_memory, is_the_least_of_nested_groups_of_version_1)
{
  put("proc/self/cgroup", "5:cpu,cpuacct:/a\n4:hugetlb,memory:/a/b\n1:name=systemd:/a\n0::/a\n");
  put("sys/fs/cgroup/memory/a/b/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_GT(memory(), 9e18);  // the kernel's word for none
  put("sys/fs/cgroup/memory/a/memory.limit_in_bytes", "700000000\n");
  EXPECT_EQ(memory(), 7e8);
  put("sys/fs/cgroup/unified/a/memory.max", "600000000\n");
  EXPECT_EQ(memory(), 6e8);
}

// There, the limit is in the root of the tree, and /proc may tell a path from outside.
TEST_F(Machine_memory, is_that_of_a_container)
{
  for (const std::string group : {"/", "/docker/0123456789abcdef"}) {
    put("proc/self/cgroup", "0::" + group + "\n");
    put("sys/fs/cgroup/memory.max", "400000000\n");
    EXPECT_EQ(memory(), 4e8) << group;
    put("proc/self/cgroup", "3:memory:" + group + "\n");
    put("sys/fs/cgroup/memory/memory.limit_in_bytes", "300000000\n");
    EXPECT_EQ(memory(), 3e8) << group;
  }
}

TEST_F(Machine_memory, of_this_machine_is_positive_and_finite)
{
  EXPECT_GT(conformal::machine_memory(), 1e8);
  EXPECT_LE(conformal::machine_memory(), conformal::memory_of_control_groups());
  EXPECT_TRUE(std::isfinite(conformal::machine_memory()));
}

}  // namespace cgp_test::machine_memory_tests
