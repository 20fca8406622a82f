// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace conformal {

/// beyond these the result of a transformation does not verify
struct Verification_limits {
  double closure = 0.1;          ///< of the relative closure residual
  double quasi_conformal = 1.5;  ///< of the mean Q
  double flipped = 0.01;         ///< of the share of flipped faces
  double direction_error = 10;   ///< of directions at the boundary, the mean in degrees
  double gamma_radius = 2;       ///< of the constant that binormals add to rho, times the radius
  double realised = 0.44;  ///< the least share of the norm of rho that closes handles and holes
  double kept = 0.1;       ///< the least share of it that the bound on lengths may keep
  double collapsed = 0.5;  ///< of the share of the area that shrank below a tenth
};

}  // namespace conformal
