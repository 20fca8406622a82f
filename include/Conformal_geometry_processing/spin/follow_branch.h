// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_FOLLOW_BRANCH_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_FOLLOW_BRANCH_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/operators/Dirac_gram.h>

#include <limits>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgSpin
/// \brief a point on a branch of eigenpairs of D - t rho, within the span of some vectors.
struct Branch_point {
  double t = 0;
  double gamma = 0;             ///< the eigenvalue, in 1/length
  Quaternion_vector<double> c;  ///< coefficients of the eigenvector, of norm one
  /// distance of gamma to the next eigenvalue in the span, and the least on the way to this point
  double gap = std::numeric_limits<double>::infinity();
  double least_gap = std::numeric_limits<double>::infinity();
};

/// \ingroup PkgSpin
/// \brief follows a branch from a point to `end`, or as far as its vector overlaps with the first
/// one by `least_overlap`.
///
/// Each step takes the smallest eigenvectors of the energy of t rho + sigma, with sigma the
/// eigenvalue itself, hence D - t rho - sigma, whose square is the energy, has it at zero, and
/// cannot mix it with eigenvectors of opposite sign. The signed form alone would not do: it is
/// indefinite, and a projection of it has eigenvalues that belong to no vector.
///
/// Steps are at least 1/24 long: two branches that cross are coupled a little by errors of the span
/// or the mesh, and shorter steps would turn off at every crossing.
/// \pre the vectors of `gram` are orthonormal with respect to the vertex areas
Branch_point follow_branch(const Dirac_gram& gram, const Branch_point& first, double end,
                           double least_overlap);

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/follow_branch_impl.h>
#endif

#endif
