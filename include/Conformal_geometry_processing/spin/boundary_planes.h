// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Reduced_basis.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the spins that turn U into V, up to rotations about V: an orthonormal basis (q, -q V) of
/// the plane { l : U l = l V } of quaternions, where q is `rotor(U, V)`.
///
/// The matrix W of [CGP 5.7] has the wrong sign in its rotor; this q turns U into V. If V = -U, the
/// rotor is not unique, and it has to vary smoothly along the boundary: q is then the half turn
/// about the given axis.
/// \param axis not parallel to U; need not be orthogonal to it
/// \pre U and V are unit vectors
internal::Reduced_basis<double>::Plane boundary_plane(const Eigen::Vector3d& U,
                                                      const Eigen::Vector3d& V,
                                                      const Eigen::Vector3d& axis);

/// \ingroup PkgSpin
/// \brief chooses the signs of quaternions along loops so that the rotation from one to the next is
/// smallest, and each loop as a whole is nearest to 1.
///
/// Two quaternions of opposite sign represent the same rotation, and a smooth lambda needs
/// consistent signs.
/// \returns for each loop whether the signs agree where it closes; if not, lambda would have to
/// make a full turn somewhere, as on a surface of another spin structure
/// \param values one for each vertex, loop after loop
std::vector<char> make_continuous(const std::vector<std::vector<int>>& loops,
                                  std::vector<Quaternion<double>>& values);

/// \ingroup PkgSpin
/// \brief the spin at the boundary that turns a frame into a target frame and scales the boundary
/// by a given ratio of lengths: conjugate(l) T l = ratio T^, and likewise N and B [CGP 6.3.2].
///
/// [CGP 6.3.2] leaves |lambda|^2 undetermined, which would cause a constant error in the positions.
/// The signs may jump; see `make_continuous()`.
Quaternion<double> boundary_spin(const internal::Boundary_frame& source,
                                 const internal::Boundary_frame& target, double ratio);

}  // namespace Conformal_geometry_processing
