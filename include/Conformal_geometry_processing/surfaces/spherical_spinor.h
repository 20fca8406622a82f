// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion.h>
#include <Conformal_geometry_processing/exceptions.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \throw Precondition_error if there is no spherical spinor with these numbers
void require_spherical_spinor(int kappa, int s, const std::string& function);

/// \ingroup PkgSurfaces
/// \brief Returns Omega_kappa,s on the unit sphere: the eigenfunctions of the Dirac operator in
/// closed form, D Omega = -(kappa + 1) Omega [CGP 6.5.1].
///
/// With mu = s + 1/2 and l = |kappa + 1/2| - 1/2,
///
///     psi_1 = sgn(-kappa) sqrt((kappa - mu + 1/2) / (2 kappa + 1)) Y_l^(mu - 1/2),
///     psi_2 =             sqrt((kappa + mu + 1/2) / (2 kappa + 1)) Y_l^(mu + 1/2)
///
/// (the text has Y_l^(mu - 1/2) in both), and Omega = psi_2 - j psi_1, where complex numbers act
/// from the right as R + R k. Orthonormal on the sphere. The spinors of -s - 1 and s differ by a
/// constant factor, so 0 <= s < |kappa| gives all surfaces.
/// \param kappa not zero \param s from -|kappa| to |kappa| - 1
/// \param point not zero; only its direction is used
/// \pre `require_spherical_spinor()` holds
Quaternion<double> spherical_spinor(int kappa, int s, const Eigen::Vector3d& point);

}  // namespace Conformal_geometry_processing
