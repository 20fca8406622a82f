// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/conformal_modulus.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <cmath>
#include <complex>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief Returns the reduced modulus of a mesh of a torus; computes a harmonic basis.
/// \throw Precondition_error if the mesh is not a closed torus
/// \throw Solver_error if the Laplacian cannot be factored
inline std::complex<double> conformal_modulus(const Mesh_view& mesh)
{
  return conformal_modulus(mesh, Hodge_decomposition(mesh).harmonic_basis());
}

/// \ingroup PkgSurfaces
/// \brief Finds the torus of a family whose modulus has the imaginary part b. If all tori of the
/// family are conformally rectangular by reflection symmetry, it is the one of sides 1 and b.
///
/// Computes about ten moduli, with one factorization of the Laplacian each.
/// \param family maps a number to a mesh, whose modulus must be a continuous function of it
/// \param low, high bracket the solution: the imaginary part is below b at one, and above it at the
/// other
/// \throw Precondition_error if they do not, or a mesh is not a closed torus
/// \throw Solver_error if a factorization fails
template <class Family>
Mesh_view torus_of_class(Family family, double b, double low, double high)
{
  const auto excess = [&](double x) { return conformal_modulus(family(x)).imag() - b; };
  double at_low = excess(low), at_high = excess(high);
  if (!(at_low * at_high <= 0))
    throw Precondition_error("torus_of_class", "the moduli are " + std::to_string(at_low + b) +
                                                   " i and " + std::to_string(at_high + b) +
                                                   " i at the ends; " + std::to_string(b) +
                                                   " i is not between them");
  // Illinois variant of regula falsi: halves the value at a retained end.
  const double tolerance = 1e-10;
  for (int i = 0; i < 100; ++i) {
    const double x = (low * at_high - high * at_low) / (at_high - at_low), at_x = excess(x);
    if (std::abs(at_x) < tolerance || x == high) return family(x);
    if ((at_x < 0) == (at_high < 0))
      at_low /= 2;
    else
      low = high, at_low = at_high;
    high = x, at_high = at_x;
  }
  return family(high);
}

}  // namespace Conformal_geometry_processing
