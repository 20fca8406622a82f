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
inline std::ostream& operator<<(std::ostream& out, const Parameterization_report& r)
{
  const Conformality& c = r.conformality;
  return out << "eigenvector            " << (r.converged ? "found" : "NOT found") << ", residual "
             << r.residual << " after " << r.iterations << " iterations\n"
             << "eigenvalue             " << r.eigenvalue << " (next one " << r.next_eigenvalue
             << ")\nquasi-conformal error  " << c.quasi_conformal.mean << " mean, "
             << c.quasi_conformal.p99 << " for 99 %, " << c.quasi_conformal.max
             << " at most (1 is conformal)\n"
             << "length cross-ratios    changed by " << c.length_cross_ratio.rms << " rms, "
             << c.length_cross_ratio.max << " at most (0 is conformal)\n"
             << "lengths                scaled by " << c.scale.min_scale << " to "
             << c.scale.max_scale << "\nflipped faces          " << c.flipped_faces << '\n';
}

}  // namespace Conformal_geometry_processing

#endif
