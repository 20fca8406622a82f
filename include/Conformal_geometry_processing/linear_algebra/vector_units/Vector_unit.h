// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_VECTOR_UNIT_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_VECTOR_UNIT_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/unit_tags.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the name of the unit on this architecture, such as "SSE2".
const char* to_string(Vector_unit unit);

/// \ingroup PkgLinearAlgebra
/// \brief whether the library has kernels for the unit and the machine can run them.
///
/// The compiled library has all of its architecture. Used header-only there is one: the widest for
/// which the including file is compiled.
bool has_vector_unit(Vector_unit unit);

/// \ingroup PkgLinearAlgebra
/// \brief the unit that factors made from now on use: the widest there is, unless
/// `set_vector_unit()` has asked for another one.
Vector_unit vector_unit();

/// \ingroup PkgLinearAlgebra
/// \brief lets every solver that is analyzed from now on, in the whole process, use the unit.
///
/// For tests, and for results that are the same to the bit on different machines: those of
/// different units differ in roundings. Solvers keep the unit they have begun with. May be called
/// from any thread. \returns false, and changes nothing, if `has_vector_unit()` is false
bool set_vector_unit(Vector_unit unit);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/vector_units/Vector_unit_impl.h>
#endif

#endif
