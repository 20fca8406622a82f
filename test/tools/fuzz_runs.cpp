// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Runs the program's commands on damaged small surfaces, targets and curves and counts the
// outcomes:
//   fuzz_runs [MUTANTS [SEED [SECONDS [COMMAND]]]]
// prints a row per format: how many of MUTANTS runs (10000), made from the seed SEED (1), each
// allowed SECONDS (20), end with which result, break a law (crash) or do not end. The commands take
// turns; COMMAND leaves only its own. The exit code is 1 if any run crashed or hung; its mutant is
// kept as fuzz_SEED_NUMBER.EXTENSION, and its command printed. See doc/fuzzing.md.

#include "fuzz_named_run.h"
#include "fuzz_runs_mutations.h"
#include "fuzz_runs_seeds.h"

namespace {

std::vector<std::string> seeds_of(const std::string& extension)
{
  if (extension == ".json") return fuzz::targets_seeds();
  if (extension == ".svg") return fuzz::svg_seeds();
  if (extension == ".csv") return fuzz::curve_seeds();
  std::vector<std::string> files;
  for (const fuzz::Mesh_view& mesh : fuzz::seed_surfaces())
    for (const bool is_text : {true, false})
      files.push_back(fuzz::seed_file(mesh, extension, is_text));
  return files;
}

std::vector<fuzz::Command> commands_named(const std::string& name, const std::string& extension)
{
  std::vector<fuzz::Command> commands;
  for (const fuzz::Command& command : fuzz::commands_for(extension))
    if (name.empty() || command.front() == name) commands.push_back(command);
  return commands;
}

// Of JSON, what is said is damaged half of the time.
std::string mutant_of(const std::vector<std::string>& seeds, const std::string& extension,
                      std::uint64_t seed, unsigned long number)
{
  fuzz::Surface_mutator mutator(seed * 1000003 + number);
  const std::string& file = seeds[mutator.below(seeds.size())];
  const bool is_glb = extension == ".glb", is_json = extension == ".json" || extension == ".gltf";
  if ((is_glb || is_json) && mutator.below(2) == 0)
    return is_glb ? fuzz::mutant_of_glb(file, mutator) : fuzz::mutant_of_json(file, mutator);
  return mutator.mutant(file);
}

fuzz::Subject subject(const std::string& extension, std::uint64_t seed,
                      const std::vector<fuzz::Command>& commands)
{
  const std::vector<std::string> seeds = seeds_of(extension);
  const auto command_of = [=](unsigned long number) { return commands[number % commands.size()]; };
  return {"`" + extension + "`", extension,
          [=](unsigned long number) { return mutant_of(seeds, extension, seed, number); },
          [=](unsigned long number, const std::string& text) -> std::size_t {
            return fuzz::fate(command_of(number), text, extension);
          },
          [=](unsigned long number) { return fuzz::text_of(command_of(number)); }};
}

}  // namespace

int main(int argc, char** argv)
{
  const fuzz::Request request = fuzz::requested(argc, argv);
  const std::string name = argc > 4 ? argv[4] : "";
  bool is_known = false;
  fuzz::Trials trials(request, fuzz::fates());
  for (const char* extension :
       {".off", ".obj", ".ply", ".stl", ".glb", ".gltf", ".vtk", ".vtp", ".json", ".svg", ".csv"}) {
    const auto commands = commands_named(name, extension);
    is_known = is_known || !commands.empty();
    if (!commands.empty()) trials.make(subject(extension, request.seed, commands));
  }
  fuzz::require(is_known, "no such command: " + name);
  return trials.is_clean() ? 0 : 1;
}
