// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/vector_units/Front_kernels.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Returns the name of the unit on this architecture, such as "SSE2".
const char* to_string(internal::Vector_unit unit);

/// \ingroup PkgLinearAlgebra
/// \brief Returns whether the library has kernels for the unit and the machine supports it.
///
/// The compiled library has kernels for all units of its architecture; header-only, there is one
/// unit: the widest for which the including file is compiled.
bool has_vector_unit(internal::Vector_unit unit);

/// \ingroup PkgLinearAlgebra
/// \brief Returns the unit for factors created from now on: the widest one available, unless
/// `set_vector_unit()` has selected another one.
internal::Vector_unit vector_unit();

/// \ingroup PkgLinearAlgebra
/// \brief Selects the unit for every solver that is analyzed from now on, in the whole process.
///
/// For tests, and for bitwise reproducible results on different machines: results of different
/// units differ by rounding. Existing solvers keep their unit. May be called from any thread.
/// \returns false, and changes nothing, if `has_vector_unit()` is false
bool set_vector_unit(internal::Vector_unit unit);

/// \ingroup PkgLinearAlgebra
/// \brief Returns the kernels for scalars of 1, 2 or 4 real components.
///
/// \tparam Real the numbers stored, `double` or `float`
/// \pre `has_vector_unit(unit)`
template <class Real>
internal::Front_kernels<Real> kernels_for(int planes, internal::Vector_unit unit = vector_unit());

}  // namespace Conformal_geometry_processing
