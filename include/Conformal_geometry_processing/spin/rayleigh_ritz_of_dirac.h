// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_RAYLEIGH_RITZ_OF_DIRAC_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_RAYLEIGH_RITZ_OF_DIRAC_H

#include <Conformal_geometry_processing/operators/dirac_forms.h>

namespace Conformal_geometry_processing {

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
