// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <iosfwd>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// \brief Measures of conformality of the map between two surfaces of the same connectivity, part
/// of the report of every transformation of the library.
struct Conformality {
  internal::Distribution quasi_conformal;  ///< of Q >= 1 over the old area
  /// mean of Q over the new area: it sees bad faces that were small and have become most of the
  /// surface
  double quasi_conformal_of_new_area = 1;
  internal::Length_cross_ratio_change length_cross_ratio;
  internal::Area_distortion scale;  ///< of lengths
  int flipped_faces = 0;
  double flipped_share = 0;  ///< of the number of faces

  /// bounds of what counts as a conformal map
  struct Limits {
    double quasi_conformal = 1.5;  ///< of the mean of Q over the old and over the new area
    double flipped_share = 0.01;   ///< of the faces
    double collapsed_share = 0.5;  ///< of the old area
  };

  /// which of the limits is exceeded, the first one; numbers that are not finite exceed all
  enum class Fault { none, not_conformal, flipped, collapsed };
  Fault fault(const Limits& limits) const;
};

/// \relates Conformality
const char* to_string(Conformality::Fault fault);

/// \ingroup PkgMeasure
/// For coordinates of 1e-150 to 1e150.
/// \param positions the new ones, 3 x |V|
/// \param expected_normals 3 x |F|, to detect flipped faces (`flipped_faces()`)
Conformality conformality(const Mesh_view& mesh, const Points& positions,
                          const Points& expected_normals);

namespace internal {

/// the same of a surface in parts
/// \pre squares of areas neither overflow nor underflow
Conformality measured_conformality(const Mesh_view& mesh, const Points& positions,
                                   const Points& expected_normals, const Surface_part& part = {});

/// Writes the lines on conformality of a report, one fact per line
void print_conformality(std::ostream& out, const Conformality& c);

}  // namespace internal
}  // namespace Conformal_geometry_processing
