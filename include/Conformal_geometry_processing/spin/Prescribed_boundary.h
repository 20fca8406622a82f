// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>
#include <Quaternionic_linear_algebra/direct/Dirichlet_solver.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
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

/// \brief spins and positions of a surface whose boundary is mapped to a given curve with given
/// normals [CGP 6.3.2].
///
/// At the boundary lambda is known: it rotates the frame of the surface into that of the curve and
/// scales by the ratio of lengths. Inside it minimises |(D - rho) lambda|^2, which is a linear
/// system. Spins of opposite signs have the same positions, so each loop has a sign of its own, of
/// which those with the least energy belong to the surface. The positions solve (5.5) with the
/// boundary fixed on the curve. Curves inside the surface are treated in the same way. With a
/// finite weight w, both minimise in addition w / R times the integral along the boundary of the
/// squared difference from what is given, where pi R^2 is the area.
///
class Prescribed_positions {
 public:
  /// \param surface must outlive the object
  /// \param condition of kind `positions`
  /// \param pattern `vertex_graph(surface)`
  /// \param solver of the same traits; its symbolic analysis is shared
  /// \throw Precondition_error if no continuous lambda exists, because the normals of the curve
  /// make one turn too many relative to those of the surface (their spin structures differ); if the
  /// curve folds back at a vertex, or its normal is parallel to it
  Prescribed_positions(const Surface_ref& surface, const Boundary_condition& condition,
                       std::shared_ptr<const Sparse_pattern> pattern,
                       const Solver_ref<Quaternion<double>>& solver, const std::string& function)
      : m_surface(surface),
        m_frames(frames_of(surface, condition)),
        m_targets(condition.targets),
        m_weights(weights(condition.weight)),
        m_spins(spins(condition, function)),
        m_lambda(pattern, m_frames.vertices, solver),
        m_positions(std::move(pattern), m_frames.vertices, solver)
  {}

  /// \brief factors the interior part of X.
  /// \throw Solver_error if the factorization fails
  void factorize(const Hermitian_sparse_matrix<Quaternion<double>>& X) { factorize(m_lambda, X); }

  /// \brief lambda, |V|: the minimiser of the energy with the given values at the boundary, whose
  /// signs it chooses
  /// \pre X has been factorized
  Quaternion_vector<double> spins(const Hermitian_sparse_matrix<Quaternion<double>>& X);

  /// residual of the linear system, relative to the contribution of the boundary
  double residual(const Hermitian_sparse_matrix<Quaternion<double>>& X,
                  const Quaternion_vector<double>& lambda) const;

  /// the positions that fit the edges best with the boundary on the curve; 3 x |V|
  /// \throw Solver_error if the Laplacian cannot be factored
  Points positions(const Eigen::MatrixX3d& edges);

  /// how far each boundary vertex is from the curve
  Eigen::VectorXd errors(const Points& f) const;

 private:
  /// w / R times the length of the boundary at each vertex; empty if positions are exact
  Eigen::VectorXd weights(double weight) const;

  template <class Solver, class Matrix>
  void factorize(Solver& solver, const Matrix& A)
  {
    m_weights.size() > 0 ? solver.factorize(A, m_weights) : solver.factorize(A);
  }

  /// zero but on a loop, each of which has a column
  Block<Quaternion<double>> given_spins() const;

  /// \brief the signs of loops, one after another, of which the next is the loop that changes the
  /// energy most
  /// \param S the energy as a quadratic form of the signs
  static Eigen::VectorXd signs(const Eigen::MatrixXd& S);

  std::vector<Quaternion<double>> spins(const Boundary_condition& condition,
                                        const std::string& function) const;

  /// \param first index of the first vertex of the loop among all boundary vertices
  Quaternion<double> spin_at(const Boundary_condition& condition, std::size_t first,
                             const std::vector<int>& loop, std::size_t k,
                             const std::string& function) const;

  Surface_ref m_surface;
  Boundary_frames m_frames;
  Points m_targets;
  Eigen::VectorXd m_weights;  // |V|
  std::vector<Quaternion<double>> m_spins;
  Dirichlet_solver<Quaternion<double>> m_lambda;
  Dirichlet_solver<double> m_positions;
};

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

}  // namespace Conformal_geometry_processing
