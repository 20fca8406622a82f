// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <gtest/gtest.h>

#include <cstdint>

#include "support/dense.h"

/// Right-hand sides of D^H M D Y = c on closed surfaces, and what their solutions fulfil.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

/// columns of random quaternions without sum
Quaternion_matrix sources(int rows, int columns);

/// solutions of mean zero
void expect_solutions(const CGP::Surface_ref& surface, const Quaternion_matrix& Y,
                      const Quaternion_matrix& c);

}  // namespace cgp_test
