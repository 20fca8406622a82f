// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Reads damaged mesh files and counts what becomes of them:
//   fuzz_readers [MUTANTS [SEED [SECONDS]]]
// prints `format | read | refused | crash | hang` for MUTANTS files per format (10000), made from
// the seed SEED (1), each allowed SECONDS (10). Mutants run in a child process, which is replaced
// when it dies; build with -fsanitize=address,undefined to see more than crashes. What is read is
// also checked, written in every format, and read again from PLY. The exit code is 1 if any mutant
// crashed or hung; such mutants are saved as fuzz_FORMAT_NUMBER.bin.

#include "conformal/io/io_errors.h"
#include "conformal/io/read_obj.h"
#include "conformal/io/read_off.h"
#include "conformal/io/read_ply.h"
#include "conformal/io/read_stl.h"
#include "conformal/io/read_surface.h"
#include "conformal/io/write_glb.h"
#include "conformal/io/write_obj.h"
#include "conformal/io/write_off.h"
#include "conformal/io/write_ply.h"
#include "fuzz_readers_mutations.h"
#include "fuzz_readers_seeds.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace {

using conformal::Surface_file;

struct Format {
  const char* name;
  const char* path;
  std::vector<std::string> seeds;
  Surface_file (*parse)(std::string_view, const std::string&);
};

// in memory that parent and child share
struct Tally {
  unsigned long next, read, refused;
};

void require(bool condition)
{
  if (!condition) std::abort();
}

// What the readers guarantee, and that every writer takes it.
void check(const Surface_file& file)
{
  for (const auto& point : file.points)
    for (const double x : point) require(std::isfinite(x));
  require(file.points.size() == file.vertices.size && file.polygons.size() == file.faces.size);
  for (const int corner : file.polygons.corners)
    require(corner >= 0 && static_cast<std::size_t>(corner) < file.points.size());
  std::vector<std::string> notes;
  conformal::encode_off(file, notes);
  conformal::encode_obj(file, notes);
  try {
    conformal::encode_glb(file, "", notes);
  } catch (const conformal::Write_error&) {  // coordinates that are no floats
  }
  for (const auto encoding :
       {conformal::Ply_encoding::ascii, conformal::Ply_encoding::big_endian}) {
    const std::string ply = conformal::encode_ply(file, encoding, notes);
    const Surface_file again = conformal::parse_ply(ply, "again.ply");
    require(again.points == file.points && again.polygons.corners == file.polygons.corners);
    require(conformal::encode_ply(again, encoding, notes) == ply);
  }
}

std::string mutant(const Format& format, std::uint64_t seed, unsigned long number)
{
  fuzz::Mutator mutator(seed * 1000003 + number);
  const std::string text = format.seeds[mutator.below(format.seeds.size())];
  return mutator.mutant(text);
}

[[noreturn]] void run(const Format& format, std::uint64_t seed, unsigned long mutants,
                      unsigned seconds, Tally& tally)
{
  while (tally.next < mutants) {
    const std::string text = mutant(format, seed, tally.next++);
    ::alarm(seconds);
    bool is_read = false;
    try {
      // by content every second time, so that detection is tried as well
      check(tally.next % 2 == 0 ? format.parse(text, format.path)
                                : conformal::parse_surface(text, format.path));
      is_read = true;
    } catch (const conformal::Read_error&) {
    }
    ++(is_read ? tally.read : tally.refused);
  }
  std::_Exit(0);
}

struct Deaths {
  unsigned long crashes = 0, hangs = 0;
};

Deaths supervise(const Format& format, std::uint64_t seed, unsigned long mutants, unsigned seconds,
                 Tally& tally)
{
  Deaths deaths;
  tally = Tally{};
  while (tally.next < mutants) {
    const pid_t child = ::fork();
    require(child >= 0);
    if (child == 0) run(format, seed, mutants, seconds, tally);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
    const bool hung = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
    ++(hung ? deaths.hangs : deaths.crashes);
    const unsigned long number = tally.next - 1;
    std::ofstream("fuzz_" + std::string(format.name) + '_' + std::to_string(number) + ".bin")
        << mutant(format, seed, number);
  }
  return deaths;
}

}  // namespace

int main(int argc, char** argv)
{
  const unsigned long mutants = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 10000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto seconds = static_cast<unsigned>(argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 10);
  const std::vector<Format> formats = {{"OFF", "a.off", fuzz::off_seeds(), conformal::parse_off},
                                       {"OBJ", "a.obj", fuzz::obj_seeds(), conformal::parse_obj},
                                       {"PLY", "a.ply", fuzz::ply_seeds(), conformal::parse_ply},
                                       {"STL", "a.stl", fuzz::stl_seeds(), conformal::parse_stl}};
  void* shared =
      ::mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  require(shared != MAP_FAILED);
  Tally& tally = *static_cast<Tally*>(shared);
  std::cout << "format |  read | refused | crash | hang\n" << std::flush;
  bool clean = true;
  for (const Format& format : formats) {
    const Deaths deaths = supervise(format, seed, mutants, seconds, tally);
    std::printf("%-6s | %5lu | %7lu | %5lu | %4lu\n", format.name, tally.read, tally.refused,
                deaths.crashes, deaths.hangs);
    std::fflush(stdout);
    clean = clean && deaths.crashes == 0 && deaths.hangs == 0;
  }
  return clean ? 0 : 1;
}
