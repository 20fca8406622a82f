// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace cgp_benchmark {

/// \brief Runs this program again with the arguments; its output is passed through.
///
/// One thread of BLAS and CHOLMOD: others wait in busy loops, which would count as work.
/// \returns a description of the failure, empty on success
inline std::string run_anew(std::vector<std::string> arguments)
{
  std::vector<char*> pointers{const_cast<char*>("benchmark_solvers")};
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    for (const char* limit : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "OMP_THREAD_LIMIT"})
      setenv(limit, "1", 0);
    execv("/proc/self/exe", pointers.data());
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return "no process";
  if (WIFSIGNALED(status)) return "stopped by signal " + std::to_string(WTERMSIG(status));
  return WEXITSTATUS(status) == 0 ? "" : "exit code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace cgp_benchmark
