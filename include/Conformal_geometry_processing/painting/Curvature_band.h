// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PAINTING_CURVATURE_BAND_H
#define CONFORMAL_GEOMETRY_PROCESSING_PAINTING_CURVATURE_BAND_H

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgPainting
/// \brief what a filter leaves of a function whose high frequencies are known, on a picture or on a
/// surface [CGP 6.2]
enum class Curvature_band {
  low,     ///< the function without the high ones: keeps the large features
  high,    ///< the high ones alone: keeps the small features
  unsharp  ///< the function and the high ones once more, by an amount: lifts the small features out
};

/// \ingroup PkgPainting
/// \brief the band of a function.
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

#endif
