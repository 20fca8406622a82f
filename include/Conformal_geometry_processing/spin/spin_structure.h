// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief the regular homotopy class of an immersed closed surface: a number modulo 2 for each
/// generating loop, and the crossings of the loops.
///
/// Surfaces of the same connectivity can be deformed into each other without creases, and are spin
/// transformations of each other up to conformal equivalence, only if all their values agree
/// [Kamberov, Pedit, Pinkall 1998].
struct Spin_structure {
  std::vector<int> values;    ///< one per loop of `loops_of_faces()`: see `turns_evenly()`
  Eigen::MatrixXi crossings;  ///< see `crossings_modulo_2()`

  /// the invariant of the class, independent of the loops: 0 for every embedded surface; 1 for
  /// instance for a torus whose cross-section is a figure eight that turns once around the axis
  int arf_invariant() const;

  friend bool operator==(const Spin_structure& a, const Spin_structure& b)
  {
    return a.values == b.values && a.crossings == b.crossings;
  }
  friend bool operator!=(const Spin_structure& a, const Spin_structure& b) { return !(a == b); }
};

/// whether the height of a face is less than a thousandth of its longest edge
bool is_thin(const Mesh_view& mesh, int f);

/// both in the normalized frame of the mesh, where squares of areas neither over- nor underflow
std::pair<Mesh_view, Points> in_frame(const Mesh_view& mesh, const Points& target);

/// \brief returns the target of a deformation.
/// \param mollification if set, thin faces are admitted, and the spin structure is not checked
/// \throw Precondition_error unless mesh and target are connected, oriented manifolds with the same
/// faces and finite coordinates, without mollification of positive areas and, if closed, with the
/// same spin structure
Points checked_target(const Mesh_view& mesh, Points target,
                      const std::optional<double>& mollification, const std::string& function);

}  // namespace internal

/// \ingroup PkgSpin
/// \brief whether the frame (direction, normal, their product) turns an even number of times along
/// a loop of faces.
///
/// A loop of rotations of space by one full turn cannot be contracted, one by two full turns can.
/// Around a point of the plane the frame turns once; therefore a loop has the value 1 if the frame
/// turns an even number of times, and 0, like a contractible loop, otherwise.
bool turns_evenly(const Mesh_view& mesh, const internal::Face_loop& loop);

/// \ingroup PkgSpin
/// \brief the spin structure of a closed surface. O(|V| + |F|) plus the lengths of its loops.
/// \pre the surface is closed, `require_surface(mesh)` holds, and no two neighbouring faces are
/// folded onto each other
internal::Spin_structure spin_structure(const Mesh_view& mesh);

/// \ingroup PkgSpin
/// \throw Precondition_error if a closed surface and its deformation have different spin
/// structures, so that no spin transformation leads from one to a surface near the other. Loops
/// through thin faces, or along which the deformation turns neighbours against each other by more
/// than 120 degrees, decide nothing: noise would.
/// \pre no face has area zero before or after
/// \param positions of the deformed surface, 3 x |V|
void require_same_spin_structure(const Mesh_view& mesh, const Points& positions,
                                 const std::string& function);

/// \ingroup PkgSpin
/// \brief the spins of the similarities nearest to the deformation of each face, |F| of either sign
/// [CGP 5.9, 6.3].
///
/// A linear map takes a face to its image; its nearest rotation, times the square root of its
/// determinant, maps the edges v to conjugate(q) v q. Both q and -q represent it.
/// \param positions of the deformed surface, 3 x |V|
/// \pre no face has area zero before or after
Quaternion_vector<double> face_spins(const Mesh_view& mesh, const Points& positions);

/// \ingroup PkgSpin
/// \brief replaces the spins of faces that are thin before or after the deformation, which depend
/// on rounding or do not exist, by the mean of their neighbours, ring by ring.
void replace_thin_faces(const Mesh_view& mesh, const Points& positions,
                        Quaternion_vector<double>& spins);

/// \ingroup PkgSpin
/// \brief chooses the signs of face spins such that they agree with those of their neighbours along
/// a spanning tree of the faces.
///
/// Otherwise the mean over the faces at a vertex would have arbitrary signs once rotations exceed
/// half a turn.
/// \returns the number of edges with opposite signs on their sides: zero for deformations that are
/// smooth at the scale of the faces, unless the spin structures differ
int make_consistent(const Mesh_view& mesh, Quaternion_vector<double>& spins);

/// \ingroup PkgSpin
/// the area-weighted mean of the faces around each vertex, |V|
Quaternion_vector<double> vertex_spins(const Mesh_view& mesh,
                                       const Quaternion_vector<double>& face_spins);

}  // namespace Conformal_geometry_processing
