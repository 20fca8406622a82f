// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_RAYLEIGH_RITZ_OF_DIRAC_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_RAYLEIGH_RITZ_OF_DIRAC_H

#include <Conformal_geometry_processing/operators/dirac_forms.h>

#include <array>

namespace Conformal_geometry_processing {

namespace internal {

// Tangent of twice the angle from which a mixture matters: two degrees.
inline constexpr double visible_mixture = 0.06;

}  // namespace internal

/// \ingroup PkgSpin
/// \brief whether a vector alone proves that X has not mixed it.
///
/// A mixture of eigenvectors of D - rho with eigenvalues +-g by the angle t has the signed quotient
/// g cos 2t, and the energy g^2 plus the discretisation error: if they nearly agree, t is small.
/// \param gamma signed quotient of the vector
/// \param mu its eigenvalue of X
bool is_surely_unmixed(double gamma, double mu);

/// \ingroup PkgSpin
/// \brief whether X has mixed two eigenvectors of D - rho of opposite sign.
///
/// X is a square: if D - rho has eigenvalues near +g and -g, those of X nearly coincide, and its
/// eigenvectors are arbitrary combinations of the two wanted ones. In the signed form, a mixture
/// appears as an off-diagonal entry s that is not small relative to the difference of the diagonal
/// entries; the rotation that removes it has the angle atan(2 |s| / difference) / 2. Vectors of one
/// sign, such as those of a double eigenvalue on a symmetric surface, need no separation, because
/// their combinations are eigenvectors of D - rho as well.
/// \param forms forms of two vectors
bool has_mixed_signs(const internal::Dirac_forms& forms);

/// \ingroup PkgSpin
/// the eigenvalues of D - rho in the span of two vectors, ascending, where <B v_1, M_F B v_2> is
/// small
std::array<double, 2> signed_eigenvalues(const internal::Dirac_forms& forms);

/// \ingroup PkgSpin
/// \brief whether X has mixed two eigenvectors of D - rho such that a shift by one of their
/// eigenvalues reduces the mixture by a third or more.
///
/// The shift by a increases the distance of the squares of eigenvalues a and b of opposite sign
/// from b^2 - a^2 to (|a| + |b|)^2, by the factor (|b| + |a|) / (|b| - |a|). If |a| is already
/// small relative to |b|, an apparent mixture is an error of a coarse mesh.
/// \param forms forms of two vectors
bool separation_pays(const internal::Dirac_forms& forms);

/// \ingroup PkgSpin
/// the vectors in the span of `vectors` that diagonalise the signed form: Rayleigh-Ritz for D - rho
/// itself; |V| x k, normalised to <B v, M_F B v> = 1, ascending in their signed eigenvalue
Block<Quaternion<double>> rayleigh_ritz_of_dirac(const Block<Quaternion<double>>& vectors,
                                                 const internal::Dirac_forms& forms);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac_impl.h>
#endif

#endif
