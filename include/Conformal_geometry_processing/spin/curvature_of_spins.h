// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the rho on faces that minimises (D - rho) mu in each face: Re(conjugate(B mu) D mu) / |B
/// mu|^2 [CGP 6.3]; in 1/length. Zero where the mean B mu of a face vanishes,
/// or its area is below a millionth of the mean one.
///
/// If mu solves a Dirac equation, the result is rho + gamma of that equation.
/// \param mu |V|
Curvature_potential curvature_of_spins(const Surface_ref& surface,
                                       const Quaternion_vector<double>& mu);

}  // namespace Conformal_geometry_processing
