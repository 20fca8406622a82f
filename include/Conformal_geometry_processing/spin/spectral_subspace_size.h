// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spectral_pairs.h>

/// \file spectral_subspace_size.h
/// \brief how many eigenvectors of X are computed to find `count` eigenvalues of D - rho next to a
/// shift.

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// enough for what cuts through a multiple eigenvalue at the end, or a pair of opposite sign
int first_subspace_size(int count);

/// \ingroup PkgSpin
/// \brief a larger size, at most doubled and at most `most`, where `size` left eigenvalues out: the
/// number of eigenvectors of X grows like the energy up to which they are counted (Weyl).
/// \param pairs those found with `size`
int next_subspace_size(int size, int most, const Spectral_pairs& pairs, int count);

/// \ingroup PkgSpin
/// \brief where the search is given up: more eigenvectors are only needed if the discretisation
/// error far exceeds the distances of the eigenvalues.
int largest_subspace_size(int count);

}  // namespace Conformal_geometry_processing::internal
