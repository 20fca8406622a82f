// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Runs the program's commands on damaged small surfaces and counts the outcomes:
//   fuzz_runs [MUTANTS [SEED [SECONDS [COMMAND]]]]
// prints a row per format: how many of MUTANTS runs (10000), made from the seed SEED (1), each
// allowed SECONDS (20), end with which result, break a law (crash) or do not end. The commands take
// turns; COMMAND leaves only its own. The exit code is 1 if any run crashed or hung; its mutant is
// kept as fuzz_SEED_NUMBER.EXTENSION, and its command printed. See doc/fuzzing.md.

#include "fuzz_named_run.h"
#include "fuzz_runs_mutations.h"
#include "fuzz_runs_seeds.h"

namespace {

struct Seeds {
  explicit Seeds(const std::string& extension)
  {
    for (const fuzz::Mesh_view& mesh : fuzz::seed_surfaces())
      for (const bool is_text : {true, false})
        files.push_back(fuzz::seed_file(mesh, extension, is_text));
  }
  std::vector<std::string> files;
};

std::vector<fuzz::Command> commands_named(const std::string& name)
{
  std::vector<fuzz::Command> commands;
  for (const fuzz::Command& command : fuzz::commands())
    if (name.empty() || command.front() == name) commands.push_back(command);
  fuzz::require(!commands.empty(), "no such command: " + name);
  return commands;
}

std::string mutant_of(const Seeds& seeds, std::uint64_t seed, unsigned long number)
{
  fuzz::Surface_mutator mutator(seed * 1000003 + number);
  return mutator.mutant(seeds.files[mutator.below(seeds.files.size())]);
}

fuzz::Subject subject(const std::string& extension, std::uint64_t seed,
                      const std::vector<fuzz::Command>& commands)
{
  const Seeds seeds(extension);
  const auto command_of = [=](unsigned long number) { return commands[number % commands.size()]; };
  return {"`" + extension + "`", extension,
          [=](unsigned long number) { return mutant_of(seeds, seed, number); },
          [=](unsigned long number, const std::string& text) -> std::size_t {
            return fuzz::fate(command_of(number), text, extension);
          },
          [=](unsigned long number) { return fuzz::text_of(command_of(number)); }};
}

}  // namespace

int main(int argc, char** argv)
{
  const fuzz::Request request = fuzz::requested(argc, argv);
  const auto commands = commands_named(argc > 4 ? argv[4] : "");
  fuzz::Trials trials(request, fuzz::fates());
  for (const char* extension : {".off", ".obj", ".ply", ".stl"})
    trials.make(subject(extension, request.seed, commands));
  return trials.is_clean() ? 0 : 1;
}
