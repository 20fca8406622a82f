// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "run.h"

#include "conformal/process/Failure.h"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CONFORMAL_IS_SANITIZED
#endif
#endif

namespace {

bool is_memory_limited()
{
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

// A sanitizer has to be loaded first.
#if defined(__ELF__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(CONFORMAL_IS_SANITIZED)

extern "C" void on_blas_without_memory(int)
{
  constexpr char text[] = "conformal: error: out of memory; try: a coarser mesh\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, sizeof text - 1);
  ::_exit(static_cast<int>(conformal::Exit_code::out_of_memory));
}

// OpenBLAS starts its threads when it is loaded, before main(), and raises SIGINT if it cannot.
// This function runs before the libraries are initialized. run() installs its own signal handlers.
void expect_blas_without_memory()
{
  if (is_memory_limited()) std::signal(SIGINT, on_blas_without_memory);
}

using Function = void (*)();
__attribute__((section(".preinit_array"), used)) const Function before_libraries =
    expect_blas_without_memory;

#endif

}  // namespace

int main(int argc, char** argv)
{
  const int code = conformal::run(argc, argv);
  // A thread of OpenBLAS that finds no memory for its buffer tries again for ever, and is waited
  // for at the end of the process.
  if (is_memory_limited() && std::fflush(nullptr) == 0) ::_exit(code);
  return code;
}
