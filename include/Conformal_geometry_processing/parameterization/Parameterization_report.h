// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>

#include <ostream>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief Quality measures of a parameterization.
///
/// If a surface is far from flat, faces may be flipped, or distant parts of the image may overlap;
/// `conformality.flipped_faces` counts the former, the latter is not checked.
struct [[nodiscard]] Parameterization_report {
  bool converged = false;  ///< the eigenvector has converged to the tolerance
  double eigenvalue = 0;   ///< minimal energy over the variance of the boundary; 0 if it is flat
  double next_eigenvalue = 0;  ///< of the next map that is not a rotated image of this one
  double residual = 0;         ///< relative error estimate of the map in the norm of the energy
  int iterations = 0;
  int boundary_loops = 0;
  int normalized_vertices = 0;  ///< number of boundary vertices in the normalization

  Conformality conformality;                       ///< of the map from the surface to the plane
  internal::Distribution uniform_quasi_conformal;  ///< of Q, with equal weights of all faces

  /// Wall clock seconds
  struct Seconds {
    double setup = 0;  ///< pattern, ordering, symbolic analysis
    double assembly = 0, factorization = 0, eigenvector = 0, certificate = 0;
    double total() const { return setup + assembly + factorization + eigenvector + certificate; }
  } seconds;

  /// Returns whether a map was found; it may have flipped faces
  explicit operator bool() const { return converged; }
};

/// \relates Parameterization_report
/// Prints the report, one fact per line
std::ostream& operator<<(std::ostream& out, const Parameterization_report& r);

}  // namespace Conformal_geometry_processing
