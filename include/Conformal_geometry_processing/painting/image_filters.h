// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/painting/Curvature_band.h>
#include <Conformal_geometry_processing/painting/Gray_image.h>

namespace Conformal_geometry_processing {
/// \ingroup PkgPainting
/// \brief Returns G * g, a Gaussian blur: every pixel becomes a weighted mean of its neighbours.
///
/// At the border the weights are normalized over the existing pixels, so constant images are
/// preserved. O(pixels x radius). \param radius the standard deviation in pixels; 0 changes
/// nothing \throw Precondition_error if it is negative, not finite, or more than a million
Gray_image blurred(const Gray_image& image, double radius);

/// \ingroup PkgPainting
/// \brief Applies a standard image filter [CGP 6.2]: low-pass G * g, high-pass 1/2 + g - G * g,
/// which is gray for constant images, or unsharp mask g + amount (g - G * g). Values may leave
/// [0, 1].
/// \param radius the standard deviation of the Gaussian G in pixels
/// \throw Precondition_error as `blurred()`
Gray_image filtered(const Gray_image& image, Curvature_band band, double radius, double amount = 1);

}  // namespace Conformal_geometry_processing
