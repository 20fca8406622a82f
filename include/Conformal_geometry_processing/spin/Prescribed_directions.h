// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>
#include <Quaternionic_linear_algebra/algebra/stable_norm.h>
#include <Quaternionic_linear_algebra/direct/Dirichlet_solver.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the rotation that best turns directions U into V: the unit quaternion q that minimises
/// sum |U q - q V|^2; of several that fit about equally well (all U may be nearly parallel to one
/// line), the one nearest to 1.
/// \param U, V unit vectors, 3 x n with n > 0
Quaternion<double> best_turn(const Points& U, const Points& V);

namespace internal {

using Boundary_plane = Reduced_basis<double>::Plane;

}  // namespace internal

/// \ingroup PkgSpin
/// \brief unit quaternions, one in each plane along a closed loop, that turn as little as possible
/// from one to the next: transported without twist, with the mismatch where the loop closes
/// distributed evenly, and all rotated in their planes to be nearest to q.
///
/// With the smallest rotations of one direction into another, the two ends of the loop may be
/// opposite quaternions of one rotation. This cannot happen here, because a plane contains q, -q
/// and everything between. O(n).
/// \param planes orthonormal bases; (q, -q V) with V on the same side of all, as
/// `boundary_plane()` makes them
std::vector<Quaternion<double>> least_twist(
    const std::vector<internal::Reduced_basis<double>::Plane>& planes, const Quaternion<double>& q);

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
/// consistent signs. Those of different loops are not compared.
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

namespace internal {

/// \brief the space of spins that turn a direction of the boundary frames into prescribed
/// directions, with a smooth member, the guide, to which solutions are compared.
///
/// At the boundary, the guide consists of the rotations into the targets that twist least along the
/// boundary and are nearest to the best common rotation of the whole surface; inside it is
/// harmonic. If the problem has several solutions, the one nearest to the guide turns the surface
/// least.
///
class Prescribed_directions {
 public:
  /// \param surface must outlive the object; its positions may change
  /// \param condition of kind `directions`, with or without targets
  /// \param solver of the same traits; its symbolic analysis is shared
  Prescribed_directions(const Surface_ref& surface, const Boundary_condition& condition,
                        std::shared_ptr<const Sparse_pattern> pattern,
                        const Solver_ref<Quaternion<double>>& solver)
      : m_surface(surface),
        m_frames(boundary_frames(surface)),
        m_coefficients(stable_normalized(condition.direction)),
        m_has_targets(condition.targets.cols() > 0),
        m_targets(normalized(condition.targets)),
        m_L(pattern),
        m_harmonic(std::move(pattern), m_frames.vertices, solver)
  {
    update();
  }

  /// adopts new positions of the mesh; given targets are kept, otherwise the targets are the new
  /// directions of the mesh
  void update_geometry();

  const std::vector<int>& vertices() const { return m_frames.vertices; }

  /// the space of lambda
  const Reduced_basis<double>& basis() const { return m_basis; }

  /// the guide, |V|, an element of the space
  const Quaternion_vector<double>& guide() const { return m_guide; }

  /// unit vectors, 3 x number of `vertices()`
  const Points& targets() const { return m_targets; }

  /// \brief the angle in radians between the direction of the boundary frames of a surface of the
  /// same connectivity and the target, at each of `vertices()`.
  Eigen::VectorXd errors(const Surface_ref& surface, const Points& targets) const;

 private:
  static Points normalized(Points v);
  Points sources() const;
  void update();
  Block<Quaternion<double>> harmonic_extension(const std::vector<Quaternion<double>>& rotors);

  Surface_ref m_surface;
  Boundary_frames m_frames;
  Eigen::Vector3d m_coefficients;  // of U
  bool m_has_targets;
  Points m_targets;  // V, unit vectors
  Hermitian_sparse_matrix<double> m_L;
  Dirichlet_solver<double> m_harmonic;
  Reduced_basis<double> m_basis;
  Quaternion_vector<double> m_guide;
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
