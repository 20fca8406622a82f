// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgPainting
/// \brief Frequency band selected by a filter, for functions on an image or on a surface whose high
/// frequencies are known [CGP 6.2]
enum class Curvature_band {
  low,     ///< low-pass: keeps the large features
  high,    ///< high-pass: keeps the small features
  unsharp  ///< adds a multiple of the high frequencies: emphasizes the small features
};

/// \ingroup PkgPainting
/// \brief Returns the band of a function.
/// \param values a vector or an array
/// \param high its high frequencies
/// \param amount of `Curvature_band::unsharp`
template <class Values>
Values band_of(const Values& values, const Values& high, Curvature_band band, double amount = 1)
{
  if (band == Curvature_band::low) return values - high;
  if (band == Curvature_band::high) return high;
  return values + amount * high;
}

}  // namespace Conformal_geometry_processing
