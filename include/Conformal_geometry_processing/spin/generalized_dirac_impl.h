// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_GENERALIZED_DIRAC_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_GENERALIZED_DIRAC_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/spin/generalized_dirac.h>

namespace Conformal_geometry_processing {

CGP_INLINE void require_on_faces(const Curvature_potential& rho)
{
  if (rho.on != Curvature_potential::On::faces)
    throw Precondition_error("solve_dirac_equation",
                             "the generalized eigenproblem (5.2) needs rho on faces");
}

}  // namespace Conformal_geometry_processing

#endif
