// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_SPECTRUM_COMMAND_LINE_H
#define CONFORMAL_COMMANDS_SPECTRUM_COMMAND_LINE_H

#include "Spectrum_options.h"

#include <CLI/CLI.hpp>

namespace conformal {

inline constexpr const char* about_spectrum =
    "Finds eigenvalues of the quaternionic Dirac operator of a surface: those of the smallest\n"
    "modulus, or those nearest to a shift, with sign and multiplicity, in 1/length. Constants "
    "have\n"
    "the eigenvalue 0. At a boundary binormals are kept.\n"
    "--csv writes one line for each; --surface N -o FILE the surface whose spin is eigenfunction "
    "N.\n"
    "Example: conformal spectrum sphere.off --count 16 --csv eigenvalues.csv";

inline constexpr const char* about_sphere =
    "Makes a Dirac sphere: a conformal image of the unit sphere with Willmore energy 4 pi "
    "kappa^2,\n"
    "whose curvature half-density is a multiple of its length density, from a spherical spinor.\n"
    "For s = 0 it is immersed; for 0 < s < |kappa| it has branch points at both poles.\n"
    "Example: conformal sphere --kappa -3 --s 1 --level 6 -o dirac_sphere.ply";

/// Adds the options that are specific to `conformal spectrum`, without the output
void add_spectrum_options(CLI::App& command, Spectrum_options& options);

/// Adds the options that are specific to `conformal sphere`
void add_sphere_options(CLI::App& command, Sphere_options& options);

}  // namespace conformal

#endif
