// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PARAMETERIZATION_REPORT_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PARAMETERIZATION_REPORT_H

#include <Conformal_geometry_processing/measure/Conformality.h>

#include <ostream>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief a parameterization in numbers, which tell how good it is.
///
/// Faces may be flipped, or the image overlap itself far apart, where a surface is far from flat;
/// `conformality.flipped_faces` counts the former, nothing looks for the latter.
struct [[nodiscard]] Parameterization_report {
  bool converged = false;      ///< the eigenvector is found to the tolerance
  double eigenvalue = 0;       ///< the least energy by the spread of the boundary; 0 if it is flat
  double next_eigenvalue = 0;  ///< that of the next map that is not a turned image of this one
  double residual = 0;         ///< error estimate of the map, relative, in the norm of the energy
  int iterations = 0;
  int boundary_loops = 0;
  int normalized_vertices = 0;  ///< vertices on the boundary whose spread is kept

  Conformality conformality;             ///< of the map from the surface to the plane
  Distribution uniform_quasi_conformal;  ///< of Q, where all faces have the same weight

  /// wall clock seconds
  struct Seconds {
    double setup = 0;  ///< pattern, ordering, symbolic analysis
    double assembly = 0, factorization = 0, eigenvector = 0, certificate = 0;
    double total() const { return setup + assembly + factorization + eigenvector + certificate; }
  } seconds;

  /// whether there is a map; it may have flipped faces
  explicit operator bool() const { return converged; }
};

/// \relates Parameterization_report
/// the certificate in words, a line per fact, each ended
std::ostream& operator<<(std::ostream& out, const Parameterization_report& r);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/parameterization/Parameterization_report_impl.h>
#endif

#endif
