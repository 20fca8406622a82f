// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "flatten_options.h"

#include "option_groups.h"

namespace conformal {

void add_flatten_options(CLI::App& command, Flatten_options& options)
{
  add_input(command, options.input);
  CLI::Option* method =
      add_choice(command, "--method", options.method, {"spectral", "dirac"},
                 "spectral (normals of the faces), or as in the thesis with those of the vertices: "
                 "dirac, which is worse on scans");
  CLI::Option* loops =
      command.add_flag("--all-loops", options.all_loops,
                       "keep the spread of all boundary loops, and not of the longest alone");
  command.add_flag("--planar", options.planar, "by curvature, and not by an energy")
      ->excludes(method)
      ->excludes(loops);
  command.add_flag("--planar-mesh", options.planar_mesh,
                   "write the flat mesh, and not the surface with texture coordinates alone");
  command.add_option("--tolerance", options.tolerance, "of the spectral map")
      ->check(above_zero)
      ->capture_default_str();
}

}  // namespace conformal
