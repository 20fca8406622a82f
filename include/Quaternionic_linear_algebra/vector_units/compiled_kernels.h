// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/vector_units/Front_kernels.h>
#include <Quaternionic_linear_algebra/vector_units/Panel_kernels.h>
#include <Quaternionic_linear_algebra/vector_units/Substitution_kernels.h>

namespace Conformal_geometry_processing {
namespace internal {

// The kernels of the compiled library for units other than the baseline. Not templates, because
// only the file that is compiled for a unit may instantiate them.
Front_kernels<double> compiled_kernels(Avx2_unit, double, int planes);
Front_kernels<float> compiled_kernels(Avx2_unit, float, int planes);
Front_kernels<double> compiled_kernels(Avx512_unit, double, int planes);
Front_kernels<float> compiled_kernels(Avx512_unit, float, int planes);

template <class Unit, class Real, int planes>
Front_kernels<Real> unit_kernels_of()
{
  using Panel = Panel_kernels<Unit, Real, planes>;
  using Add = Extend_add<Unit, Real, planes>;
  using Narrow = Substitution_kernels<Unit, Real, planes, 4>;
  using Wide = Substitution_kernels<Unit, Real, planes, 8>;
  using Single = Substitution_kernels<Unit, Real, planes, planes == 1 ? 1 : 4>;
  return {Unit::unit,
          Simd_lanes<Unit, Real>::layout(planes),
          Panel::factor_panel,
          Panel::solve_below,
          Panel::set_outer_product,
          Panel::round_panel,
          Add::add_to_panel,
          Add::add_to_update,
          {Single::add_child, Single::forward, Single::backward},
          {Narrow::add_child, Narrow::forward, Narrow::backward},
          {Wide::add_child, Wide::forward, Wide::backward}};
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Returns the kernels of a vector unit for scalars of 1, 2 or 4 real components, compiled
/// in the including file.
///
/// Only for a unit that the including file is compiled for; for others see `kernels_for()`.
template <class Unit, class Real>
internal::Front_kernels<Real> unit_kernels(int planes)
{
  return planes == 1   ? internal::unit_kernels_of<Unit, Real, 1>()
         : planes == 2 ? internal::unit_kernels_of<Unit, Real, 2>()
                       : internal::unit_kernels_of<Unit, Real, 4>();
}

}  // namespace Conformal_geometry_processing
