// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Conformal_geometry_processing/surfaces/spherical_spinor.h>

#include <Eigen/Core>

#include <string>
#include <utility>

namespace Conformal_geometry_processing {

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

}  // namespace Conformal_geometry_processing
