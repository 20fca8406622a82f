// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "collective.h"
#include "spin_in_parts.h"

#include "conformal/commands/commands.h"
#include "conformal/run.h"

#include <slepcsys.h>

namespace conformal {

std::vector<Command> commands()
{
  return {mpi::spin_command()};
}

std::vector<std::string> commands_not_built()
{
  return {};
}

const char* const how_to_build_all = "";

}  // namespace conformal

int main(int argc, char** argv)
{
  int none = 1;  // the command line is not PETSc's
  if (SlepcInitialize(&none, &argv, nullptr, nullptr) != 0) return 1;
  int code = 0;
  if (conformal::mpi::rank() == 0) {
    code = conformal::run(argc, argv);
    conformal::mpi::dismiss();
  } else {
    conformal::mpi::serve();
  }
  return SlepcFinalize() != 0 && code == 0 ? 1 : code;
}
