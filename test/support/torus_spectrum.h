// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/tori.h"

namespace cgp_test {

/// \brief the derivatives at n equidistant points of the circle of the functions with
/// f(t + 2 pi) = -f(t) that n points determine, n even
Eigen::MatrixXd antiperiodic_derivative(int n);

/// \brief the eigenvalues of D of modulus below `most` on the torus of revolution of radii R and r,
/// ascending, with quaternionic multiplicities.
///
/// D is the intrinsic Dirac operator of the spin structure that does not extend to the solid, minus
/// the mean curvature H. In the frame along profile and parallel, the Fourier modes k = 1/2, 3/2,
/// ... around the axis satisfy, with the distance d(t) from it, the arc length s = r t, and
/// antiperiodic u: -u2' + (k/d) u2 = (g + H) u1, u1' + (k/d) u1 = (g + H) u2. Those of -k are their
/// images under j.
std::vector<double> torus_spectrum(double R, double r, double most);

/// the torus of revolution with vertices moved along it by up to the share `amount` of an edge
Mesh_view jittered_torus(double R, double r, int m, int n, double amount);

}  // namespace cgp_test
