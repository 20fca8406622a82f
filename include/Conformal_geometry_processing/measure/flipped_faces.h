// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_FLIPPED_FACES_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_FLIPPED_FACES_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// \brief what the normals of the faces should be if the surface does not fold: the sum of the
/// area-weighted normals of their corners; 3 x |F|, not of unit length.
Points neighbourhood_normals(const Mesh_view& mesh);

/// \ingroup PkgMeasure
/// \brief what the normals of the faces should be if a deformation folds nothing and unfolds
/// nothing: the neighbourhood normals of the new surface, reversed where a face was against its
/// neighbourhood before; 3 x |F|, not of unit length.
///
/// Where a face stood upright on its neighbourhood, or had none (area zero, faces that cancel out),
/// nothing can be told: there it is the new normal itself.
/// \param positions the new ones, 3 x |V|
Points neighbourhood_normals(const Mesh_view& before, const Points& positions);

/// \ingroup PkgMeasure
/// the number of faces whose new normal makes an obtuse angle with the one expected, or that have
/// area zero
/// \param positions the new ones, 3 x |V|
/// \param expected 3 x |F|, for instance the old normals rotated by the spins of the faces
int flipped_faces(const Mesh_view& mesh, const Points& positions, const Points& expected);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/measure/flipped_faces_impl.h>
#endif

#endif
