// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PAINTING_IMAGE_FILTERS_H
#define CONFORMAL_GEOMETRY_PROCESSING_PAINTING_IMAGE_FILTERS_H

#include <Conformal_geometry_processing/painting/Curvature_band.h>
#include <Conformal_geometry_processing/painting/Gray_image.h>

namespace Conformal_geometry_processing {
/// \ingroup PkgPainting
/// \brief G * g: every pixel becomes the mean of those around it, weighted by a Gauss function.
///
/// At the border the weights of the pixels that there are add up to one, so a constant picture
/// stays as it is. O(pixels x radius). \param radius the standard deviation in pixels; 0 changes
/// nothing \throw Precondition_error if it is negative, not finite, or more than a million
Gray_image blurred(const Gray_image& image, double radius);

/// \ingroup PkgPainting
/// \brief the usual filters of pictures [CGP 6.2]: low-pass G * g, high-pass 1/2 + g - G * g, which
/// is gray where nothing happens, and unsharp mask g + amount (g - G * g). Values may leave [0, 1].
/// \param radius the standard deviation of the Gauss function G in pixels
/// \throw Precondition_error as of `blurred()`
Gray_image filtered(const Gray_image& image, Curvature_band band, double radius, double amount = 1);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/painting/image_filters_impl.h>
#endif

#endif
