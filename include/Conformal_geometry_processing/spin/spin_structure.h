// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgSpin
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

}  // namespace Conformal_geometry_processing
