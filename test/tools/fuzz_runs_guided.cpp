// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The program's commands as a target of libFuzzer, which looks for surfaces that reach new code.
// See doc/fuzzing.md.

#include "fuzz_guided.h"
#include "fuzz_named_run.h"
#include "fuzz_runs_mutations.h"
#include "fuzz_runs_seeds.h"

#include <sys/time.h>

namespace {

const char* const extensions[] = {".off", ".obj", ".ply", ".stl"};

std::vector<std::string> seeds()
{
  std::vector<std::string> files;
  for (const fuzz::Mesh_view& mesh : fuzz::seed_surfaces())
    for (const char* extension : extensions)
      files.push_back(fuzz::seed_file(mesh, extension, mesh.size_of_vertices() % 2 == 0));
  return files;
}

// The program sets its own alarm, which libFuzzer would interpret as its own.
fuzz::Deadline& deadline()
{
  const itimerval none{};
  ::setitimer(ITIMER_REAL, &none, nullptr);
  static fuzz::Deadline limit(20, SIGABRT);
  return limit;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int random)
{
  static const std::vector<std::string> files = seeds();
  return fuzz::guided_mutant<fuzz::Surface_mutator>(data, size, max_size, random, files);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < 2) return 0;
  deadline().set();
  const std::size_t choice = data[0];
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  fuzz::fate(fuzz::commands()[choice / 4 % fuzz::commands().size()], text, extensions[choice % 4]);
  return 0;
}
