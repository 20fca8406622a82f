// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "spectrum_command_line.h"

#include "option_groups.h"

namespace conformal {

void add_spectrum_options(CLI::App& command, Spectrum_options& options)
{
  add_input(command, options.input);
  command.add_option("--count", options.count, "how many eigenvalues")
      ->check(above_zero)
      ->capture_default_str();
  command.add_option("--shift", options.shift, "those nearest to it, in 1/length")
      ->capture_default_str();
  command.add_option("--csv", options.csv, "write the eigenvalues to this file")->check(file_name);
  command
      .add_option("--resolution", options.resolution,
                  "eigenvalues nearer than this share of the largest are shown as one")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      .add_option("--surface", options.surface,
                  "write the surface of this eigenfunction, counted from 0")
      ->check(CLI::NonNegativeNumber)
      ->needs("--output");
}

void add_sphere_options(CLI::App& command, Sphere_options& options)
{
  command
      .add_option("--kappa", options.kappa, "any integer but zero; the eigenvalue is -kappa - 1")
      ->capture_default_str();
  command.add_option("--s", options.s, "from -|kappa| to |kappa| - 1; -s - 1 gives the same as s")
      ->capture_default_str();
  command.add_option("--level", options.level, "how fine: 20 * 4^level triangles, at most level 9")
      ->check(CLI::Range(0, 9))
      ->capture_default_str();
}

}  // namespace conformal
