// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_TRANSFORM_WRITE_RESULT_H
#define CONFORMAL_TRANSFORM_WRITE_RESULT_H

#include "solve_spin.h"

#include "conformal/input/Surface_input.h"
#include "conformal/input/rho.h"

#include <string>

namespace conformal {

/// Refuses before the work an output that cannot be written after it. \throws Write_error
void require_writable(const std::string& path);

/// `output` with the number of a step before its extension: `bear_0005.ply`
/// \pre `output` has an extension
std::string snapshot_path(const std::string& output, int step);

/// the input's file with other positions: normals, which are wrong now, are left out; vertices
/// without a face stay where they are
Surface_file moved(const Surface_input& input, const CGP::Points& positions);

/// Sets the vertex property `quality` (float): the quasi-conformal error, averaged by area.
void set_quality(const Surface_input& input, const CGP::Points& positions, Surface_file& file);

/// the file that `conformal spin` writes: moved, with `quality`, `rho` (in the user's frame) and,
/// if a name is given, lambda as vertex properties `<name>_w` to `<name>_z`
Surface_file spin_result_file(const Surface_input& input, const CGP::Curvature_potential& rho,
                              const Spin_solution& solution, const std::string& lambda);

}  // namespace conformal

#endif
