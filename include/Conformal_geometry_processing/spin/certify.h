// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the expected normals of the faces after a spin transformation: rotated by the mean spin
/// of their corners, 3 x |F|, not normalised.
Points rotated_normals(const Mesh_view& mesh, const Quaternion_vector<double>& lambda);

namespace internal {

/// \brief Writes into the report how conformal the map from a surface to new positions is, and the
/// ratio of the smallest to the largest spin; if a position is not finite, the result has not
/// converged.
/// \param measured the surface, or its part with positive areas
/// \param f 3 x |V| \param lambda |V|
/// \pre squares of areas neither overflow nor underflow
void certify(const Mesh_view& measured, const Points& f, const Quaternion_vector<double>& lambda,
             Spin_report& report, const Surface_part& part = {});

/// of the disk of the same area
double radius_of_area(const Surface_ref& surface, const Surface_part& part = {});

}  // namespace internal

/// \ingroup PkgSpin
/// \brief the largest singular value of D - rho, in 1/length, that the edge length explains: if
/// gamma is a misfit, larger values belong to no surface.
double greatest_misfit(const Surface_ref& surface, const internal::Surface_part& part = {});

/// \ingroup PkgSpin
/// \brief the largest modulus of gamma, in 1/length, that the edge length explains where the exact
/// eigenvalue is zero: it is of second order.
double greatest_zero(const Surface_ref& surface);

/// \ingroup PkgSpin
/// \brief whether the data prescribed at the boundary can be realised.
///
/// For realisable data, the singular value sigma of D - rho tends to zero with the edge length h;
/// otherwise it does not. The residual of the positions tends to zero with h^2. If the residual is
/// small, a surface with this boundary exists nevertheless, and its curvature is rho up to sigma;
/// prescribed binormals, which realise rho up to gamma, guarantee no more. Non-planar tangents are
/// of this kind: exact solutions are exceptional [CGP 5.7], good approximations are not.
///
/// \param sigma in 1/length; zero if it is a true eigenvalue and not a misfit
/// \param report contains the measured quantities
Spin_report::Boundary_fault boundary_fault(const Surface_ref& surface, double sigma,
                                           const Spin_report& report,
                                           const internal::Surface_part& part = {});

}  // namespace Conformal_geometry_processing
