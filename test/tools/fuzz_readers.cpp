// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Reads damaged mesh files and counts the outcomes:
//   fuzz_readers [MUTANTS [SEED [SECONDS]]]
// prints a row per format: how many of MUTANTS files (10000), made from the seed SEED (1), each
// allowed SECONDS (20), are read, refused, crash or hang. What is read is also checked, written in
// every format, and read again from PLY. The exit code is 1 if any mutant crashed or hung; such
// mutants are kept as fuzz_SEED_NUMBER.EXTENSION. See doc/fuzzing.md.

#include "fuzz_json_mutations.h"
#include "fuzz_readers_mutations.h"
#include "fuzz_readers_seeds.h"
#include "fuzz_reading.h"
#include "fuzz_trials.h"

namespace {

using Seeds = std::vector<std::string>;

std::string mutant_of(const Seeds& seeds, std::uint64_t seed, unsigned long number)
{
  fuzz::Mutator mutator(seed * 1000003 + number);
  const std::string text = seeds[mutator.below(seeds.size())];
  return mutator.mutant(text);
}

fuzz::Subject subject(const std::string& extension, const Seeds& seeds, std::uint64_t seed)
{
  return {"`" + extension + "`", extension,
          [=](unsigned long number) { return mutant_of(seeds, seed, number); },
          [=](unsigned long number, const std::string& text) -> std::size_t {
            // by content every second time, so that detection is tried as well
            return fuzz::is_read(text, extension, number % 2 == 1) ? 0 : 1;
          },
          [](unsigned long) { return "read"; }};
}

using Damage = std::string (*)(const std::string&, fuzz::Mutator&);

fuzz::Subject subject_of_json(const std::string& extension, const Seeds& seeds, Damage damage,
                              std::uint64_t seed)
{
  fuzz::Subject s = subject(extension, seeds, seed);
  s.name = "`" + extension + "`, its JSON";
  s.mutant = [=](unsigned long number) {
    fuzz::Mutator mutator(seed * 1000003 + number);
    return damage(seeds[mutator.below(seeds.size())], mutator);
  };
  return s;
}

fuzz::Subject subject_of_curves(const std::string& extension, const Seeds& seeds,
                                std::uint64_t seed)
{
  fuzz::Subject s = subject(extension, seeds, seed);
  s.run = [=](unsigned long, const std::string& text) -> std::size_t {
    return fuzz::are_curves_read(text, extension) ? 0 : 1;
  };
  return s;
}

}  // namespace

int main(int argc, char** argv)
{
  const fuzz::Request request = fuzz::requested(argc, argv);
  fuzz::Trials trials(request, {"read", "refused"});
  trials.make(subject(".off", fuzz::off_seeds(), request.seed));
  trials.make(subject(".obj", fuzz::obj_seeds(), request.seed));
  trials.make(subject(".ply", fuzz::ply_seeds(), request.seed));
  trials.make(subject(".stl", fuzz::stl_seeds(), request.seed));
  trials.make(subject(".glb", fuzz::glb_seeds(), request.seed));
  trials.make(subject_of_json(".glb", fuzz::glb_seeds(), fuzz::mutant_of_glb, request.seed));
  trials.make(subject(".gltf", fuzz::gltf_seeds(), request.seed));
  trials.make(subject_of_json(".gltf", fuzz::gltf_seeds(), fuzz::mutant_of_json, request.seed));
  trials.make(subject(".vtk", fuzz::vtk_seeds(), request.seed));
  trials.make(subject(".vtp", fuzz::vtp_seeds(), request.seed));
  trials.make(subject_of_curves(".svg", fuzz::svg_seeds(), request.seed));
  trials.make(subject_of_curves(".csv", fuzz::curve_seeds(), request.seed));
  return trials.is_clean() ? 0 : 1;
}
