// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <complex>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief Returns the spherical harmonic Y_l^m, orthonormal on the unit sphere, with the
/// Condon-Shortley phase: Y_l^-m = (-1)^m conj(Y_l^m). Zero if |m| > l or l < 0.
/// \param point not zero; only its direction is used
std::complex<double> spherical_harmonic(int l, int m, const Eigen::Vector3d& point);

/// \ingroup PkgSurfaces
/// \throw Precondition_error if there is no spherical spinor with these numbers
void require_spherical_spinor(int kappa, int s, const std::string& function);

/// \ingroup PkgSurfaces
/// \brief Returns Omega_kappa,s on the unit sphere: the eigenfunctions of the Dirac operator in
/// closed form, D Omega = -(kappa + 1) Omega [CGP 6.5.1].
///
/// With mu = s + 1/2 and l = |kappa + 1/2| - 1/2,
///
///     psi_1 = sgn(-kappa) sqrt((kappa - mu + 1/2) / (2 kappa + 1)) Y_l^(mu - 1/2),
///     psi_2 =             sqrt((kappa + mu + 1/2) / (2 kappa + 1)) Y_l^(mu + 1/2)
///
/// (the text has Y_l^(mu - 1/2) in both), and Omega = psi_2 - j psi_1, where complex numbers act
/// from the right as R + R k. Orthonormal on the sphere. The spinors of -s - 1 and s differ by a
/// constant factor, so 0 <= s < |kappa| gives all surfaces.
/// \param kappa not zero \param s from -|kappa| to |kappa| - 1
/// \param point not zero; only its direction is used
/// \pre `require_spherical_spinor()` holds
Quaternion<double> spherical_spinor(int kappa, int s, const Eigen::Vector3d& point);

/// \ingroup PkgSurfaces
/// \brief Returns the directions from the centre of a round sphere to its vertices, 3 x |V|.
/// \throw Precondition_error if a vertex deviates from the sphere by more than a thousandth of its
/// radius, or the normals point inward
Points directions_on_sphere(const Mesh_view& mesh, const std::string& function);

/// \ingroup PkgSurfaces
/// \brief Computes the surface of a spin, such as an eigenfunction found by
/// `Dirac_spectral_problem`; on the sphere a Dirac sphere, whose curvature half-density is a
/// multiple of its length density.
///
/// `report.eigenvalue` is the signed quotient of lambda. For eigenvalue gamma of the unit sphere,
/// the Willmore energy is 4 pi (1 + gamma)^2.
/// \param lambda |V|, not all zero; is rescaled
/// \throw Precondition_error if the mesh is not suitable, or lambda does not fit it
/// \throw Solver_error if a factorization fails
Spin_result surface_of_spin(const Mesh_view& mesh, Quaternion_vector<double> lambda,
                            const std::string& function = "surface_of_spin",
                            const Spin_solvers& solvers = {});

/// \ingroup PkgSurfaces
/// \brief Computes the Dirac sphere of the spherical spinor Omega_kappa,s, on a mesh of a round
/// sphere [CGP 6.5.1].
///
/// Its Willmore energy is 4 pi kappa^2. For s = 0 it is immersed; for other s >= 0 it has branch
/// points at both poles, where lambda is zero. The spheres of kappa and -kappa are point
/// reflections of each other.
/// \throw Precondition_error if kappa is zero, s is not one of -|kappa|, ..., |kappa| - 1, or the
/// mesh is not a closed sphere with normals outward
/// \throw Solver_error if a factorization fails
Spin_result spin_to_dirac_sphere(const Mesh_view& mesh, int kappa, int s,
                                 const std::string& function = "spin_to_dirac_sphere",
                                 const Spin_solvers& solvers = {});

/// \ingroup PkgSurfaces
/// \brief Computes the surface for the eigenvalue of D nearest to `wanted`, with binormals
/// preserved: for plane domains a Dirac surface, whose curvature half-density is a multiple of its
/// length half-density [CGP 6.5.2].
///
/// For a plane domain the eigenvalues are the square roots, of either sign, of the Dirichlet and
/// Neumann eigenvalues of the Laplacian: on the unit disk the zeros of Bessel functions and of
/// their derivatives. Many of these surfaces have branch points, around which coarse meshes fold
/// over; the report is false if any face flips.
/// \param wanted in 1/length; the eigenvalue itself is `wanted` plus that of the report
/// \throw Precondition_error if the mesh is not suitable, or closed
/// \throw Solver_error if a factorization fails
Spin_result dirac_disk(const Mesh_view& mesh, double wanted, const Dirac_options& options = {},
                       const std::string& function = "dirac_disk");

/// \ingroup PkgSurfaces
/// \brief Creates the unit sphere with 20 n^2 faces: divides the edges of the icosahedron into n
/// parts and projects the points of its faces. Normals point outward.
/// \param frequency n
/// \throw Precondition_error if it is below one
Mesh_view geodesic_sphere(int frequency);

}  // namespace Conformal_geometry_processing
