// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_FLIPPED_FACES_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_FLIPPED_FACES_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// \brief Returns the expected normals of the faces of a surface without folds: the sum of the
/// area-weighted normals of their corners; 3 x |F|, not of unit length.
Points neighbourhood_normals(const Mesh_view& mesh);

/// \ingroup PkgMeasure
/// \brief Returns the expected normals of the faces under a deformation that creates and removes no
/// folds: the neighbourhood normals of the new surface, reversed if a face was opposite to its
/// neighbourhood before; 3 x |F|, not of unit length.
///
/// If a face was perpendicular to its neighbourhood, or either has no normal (area zero, faces that
/// cancel out), the orientation is undefined, and the new normal itself is returned.
/// \param positions the new ones, 3 x |V|
Points neighbourhood_normals(const Mesh_view& before, const Points& positions);

/// \ingroup PkgMeasure
/// Returns the number of faces whose new normal makes an obtuse angle with the expected one, or
/// that have area zero
/// \param positions the new ones, 3 x |V|
/// \param expected 3 x |F|, for instance the old normals rotated by the spins of the faces
int flipped_faces(const Mesh_view& mesh, const Points& positions, const Points& expected);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/measure/flipped_faces_impl.h>
#endif

#endif
