// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The readers as a target of libFuzzer, which looks for files that reach new code. See
// doc/fuzzing.md.

#include "fuzz_guided.h"
#include "fuzz_readers_mutations.h"
#include "fuzz_readers_seeds.h"
#include "fuzz_reading.h"

namespace {

const char* const extensions[] = {".off", ".obj", ".ply", ".stl", ".glb"};

std::vector<std::string> seeds()
{
  return {fuzz::off_seeds()[1], fuzz::obj_seeds()[0], fuzz::ply_seeds()[0], fuzz::stl_seeds()[0],
          fuzz::glb_seeds()[0], fuzz::off_seeds()[2], fuzz::obj_seeds()[1], fuzz::ply_seeds()[2],
          fuzz::stl_seeds()[1], fuzz::glb_seeds()[1]};
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int random)
{
  static const std::vector<std::string> files = seeds();
  return fuzz::guided_mutant<fuzz::Mutator>(data, size, max_size, random, files);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < 2) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  fuzz::is_read(text, extensions[data[0] % 5], data[0] >= 128);
  return 0;
}
