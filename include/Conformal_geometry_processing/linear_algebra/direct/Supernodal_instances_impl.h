// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODAL_INSTANCES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODAL_INSTANCES_IMPL_H

// Instantiates the templates listed in Supernodal_instances.h in the compiled library.

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY

#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_cholesky_templates.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_factor_templates.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_substitution_templates.h>

namespace Conformal_geometry_processing {

#define CGP_DEFINE(Scalar, Real)                                     \
  template class internal::Supernodal_factor<Scalar, Real>;          \
  template class internal::Supernodal_substitution<Scalar, Real, 4>; \
  template class internal::Supernodal_substitution<Scalar, Real, 8>;
CGP_FOR_SUPERNODAL_INSTANCES(CGP_DEFINE)
#undef CGP_DEFINE
#define CGP_DEFINE(Scalar) template class Supernodal_cholesky<Scalar>;
CGP_FOR_SUPERNODAL_SCALARS(CGP_DEFINE)
#undef CGP_DEFINE
#define CGP_DEFINE(Scalar, Real) template class internal::Supernodal_substitution<Scalar, Real, 1>;
CGP_FOR_REAL_SUPERNODAL_INSTANCES(CGP_DEFINE)
#undef CGP_DEFINE

}  // namespace Conformal_geometry_processing

#endif

#endif
