// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_PRESCRIBED_DIRECTIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_PRESCRIBED_DIRECTIONS_H

#include <Conformal_geometry_processing/algebra/Reduced_basis.h>
#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Dirichlet_solver.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/best_turn.h>
#include <Conformal_geometry_processing/spin/boundary_planes.h>
#include <Conformal_geometry_processing/spin/least_twist.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the space of spins that turn a direction of the boundary frames into prescribed
/// directions, and a smooth member of it to which solutions are compared.
///
/// The guide turns the surface as a whole, as well as that can be done, and has at the boundary
/// the rotations into the targets that twist least along it and are nearest to that turn; inside
/// it is harmonic. Where the problem has several solutions, the one nearest to it turns the
/// surface least.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam Surface `Mesh_view` or `Delaunay_view`
template <class SolverTraits, class Surface = Mesh_view>
class Prescribed_directions {
 public:
  /// \param mesh its positions may change; must outlive the object
  /// \param condition of kind `directions`, with directions in its targets or none
  /// \param solver one of the same traits whose analysis is shared
  template <class Solver>
  Prescribed_directions(const Surface& mesh, const Boundary_condition& condition,
                        std::shared_ptr<const Sparse_pattern> pattern, const Solver& solver)
      : m_mesh(mesh),
        m_frames(boundary_frames(mesh)),
        m_coefficients(stable_normalized(condition.direction)),
        m_has_targets(condition.targets.cols() > 0),
        m_targets(normalized(condition.targets)),
        m_L(pattern),
        m_harmonic(std::move(pattern), m_frames.vertices, solver)
  {
    update();
  }

  /// the mesh has new positions; targets that were given stay, others are the directions it has
  void update_geometry()
  {
    m_frames = boundary_frames(m_mesh);
    update();
  }

  const std::vector<int>& vertices() const { return m_frames.vertices; }

  /// the space of lambda
  const Reduced_basis<double>& basis() const { return m_basis; }

  /// |V|, in the space
  const Quaternion_vector<double>& guide() const { return m_guide; }

  /// \brief the angle in radians between the direction of the boundary frames of a surface of the
  /// same connectivity and the target, at each of `vertices()`.
  Eigen::VectorXd errors(const Surface& surface) const
  {
    const Boundary_frames frames = boundary_frames(surface);
    Eigen::VectorXd angles(m_targets.cols());
    for (Eigen::Index k = 0; k < angles.size(); ++k) {
      const Eigen::Vector3d U = frames.frames[static_cast<std::size_t>(k)] * m_coefficients;
      const Eigen::Vector3d V = m_targets.col(k);
      angles[k] = std::atan2(U.cross(V).norm(), U.dot(V));
    }
    return angles;
  }

 private:
  static Points normalized(Points v)
  {
    for (Eigen::Index k = 0; k < v.cols(); ++k) v.col(k) = stable_normalized(v.col(k));
    return v;
  }

  Points sources() const
  {
    Points U(3, static_cast<Eigen::Index>(m_frames.frames.size()));
    for (std::size_t k = 0; k < m_frames.frames.size(); ++k)
      U.col(static_cast<Eigen::Index>(k)) = m_frames.frames[k] * m_coefficients;
    return U;
  }

  void update()
  {
    const Points U = sources();
    if (!m_has_targets) m_targets = U;
    std::vector<Reduced_basis<double>::Plane> planes;
    const Quaternion<double> turn = best_turn(U, m_targets);
    for (Eigen::Index k = 0; k < U.cols(); ++k) {
      const Eigen::Vector3d N = m_frames.normal(static_cast<std::size_t>(k));
      const Reduced_basis<double>::Plane rest =
          boundary_plane(spin(turn, U.col(k)), m_targets.col(k), spin(turn, N));
      planes.push_back({turn * rest[0], turn * rest[1]});
    }
    std::vector<Quaternion<double>> rotors;
    auto first = planes.begin();
    for (const std::vector<int>& loop : m_frames.loops) {
      const auto end = first + static_cast<std::ptrdiff_t>(loop.size());
      const auto section = least_twist({first, end}, turn);
      rotors.insert(rotors.end(), section.begin(), section.end());
      first = end;
    }
    m_basis = {m_mesh.size_of_vertices(), m_frames.vertices, planes};
    m_guide = m_basis.project(harmonic_extension(rotors)).col(0);
  }

  Block<Quaternion<double>> harmonic_extension(const std::vector<Quaternion<double>>& rotors)
  {
    const Eigen::Index n = m_mesh.size_of_vertices();
    Block<double> values = Block<double>::Zero(n, 4);
    for (std::size_t k = 0; k < rotors.size(); ++k)
      values.row(m_frames.vertices[k]) << rotors[k].w, rotors[k].x, rotors[k].y, rotors[k].z;
    assemble_cotan_laplacian(m_mesh, cotan_weights(m_mesh), m_L);
    m_harmonic.factorize(m_L);
    const Block<double> q = m_harmonic.solve(m_L, Block<double>::Zero(n, 4), values);
    Block<Quaternion<double>> extension(n, 1);
    for (Eigen::Index i = 0; i < n; ++i) extension(i, 0) = {q(i, 0), q(i, 1), q(i, 2), q(i, 3)};
    return extension;
  }

  const Surface& m_mesh;
  Boundary_frames m_frames;
  Eigen::Vector3d m_coefficients;  // of U
  bool m_has_targets;
  Points m_targets;  // V, unit vectors
  Hermitian_sparse_matrix<double> m_L;
  Dirichlet_solver<double, SolverTraits> m_harmonic;
  Reduced_basis<double> m_basis;
  Quaternion_vector<double> m_guide;
};

}  // namespace Conformal_geometry_processing

#endif
