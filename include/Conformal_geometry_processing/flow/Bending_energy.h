// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Fairing_patch.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief The Willmore energy of a patch whose rim is clamped, and its derivative.
///
/// W(f) = sum |L f|_v^2 / (4 A_v) over the vertices that bend, with the cotan Laplacian L and mixed
/// Voronoi areas A, both of f: the integral of H^2, for L f = 2 H N A, whose normal part is exact
/// on spheres where no face is obtuse. At the rim, L f contains the faces outside, which stay: a
/// kink there has curvature, and so normals are kept without a condition on them.
class Bending_energy {
 public:
  /// \param f positions of the vertices of the patch
  Bending_energy(const Fairing_patch& patch, const Points& f);

  /// W; dimensionless
  double value() const { return m_value; }

  /// the derivative of W by each position, exact, in 1/length; zero at held vertices
  Points gradient() const;

  const Mesh_view& mesh() const { return m_mesh; }
  const Eigen::VectorXd& weights() const { return m_weights; }  ///< of the edges in L
  const Eigen::VectorXd& areas() const { return m_areas; }      ///< of the vertices

 private:
  void add_face(int f, Points& gradient) const;

  const Fairing_patch& m_patch;
  Mesh_view m_mesh;
  Eigen::VectorXd m_weights, m_areas;
  Points m_curvature;  // L f / A = 2 H N where the surface bends, zero elsewhere
  double m_value = 0;
};

/// \brief K = L A^-1 L / 2 on the free vertices of a patch, for the vertices that bend: the second
/// derivative of the Willmore energy for a fixed metric, of each coordinate.
///
/// |free| x |free|, real symmetric, positive definite; joins vertices with a common neighbour.
class Bending_matrix {
 public:
  explicit Bending_matrix(const Fairing_patch& patch);

  const std::shared_ptr<const Sparse_pattern>& pattern() const { return m_pattern; }

  /// \brief Calls `add(k, x)` for the addends x of the value at each position k of the pattern.
  template <class Add>
  void assemble(const Bending_energy& energy, Add add) const
  {
    auto place = m_places.begin();
    for (std::size_t s = 0; s + 1 < m_offsets.size(); ++s) {
      const double inverse = .5 / energy.areas()[m_middles[s]];
      for (std::size_t p = m_offsets[s]; p < m_offsets[s + 1]; ++p)
        for (std::size_t q = m_offsets[s]; q <= p; ++q)
          add(*place++, inverse * coefficient(p, energy) * coefficient(q, energy));
    }
  }

 private:
  /// a free vertex in the row of L of a vertex that bends, and the edges to it: its one, or all of
  /// the middle
  struct Entry {
    int unknown;
    std::vector<int> edges;
  };

  double coefficient(std::size_t p, const Bending_energy& energy) const;
  void add_row(const Fairing_patch& patch, int v, const std::vector<int>& edges);
  void find_pattern(int size);

  // the rows of L of all vertices that bend, one after another
  std::vector<int> m_middles;
  std::vector<std::size_t> m_offsets{0};
  std::vector<Entry> m_entries;
  std::shared_ptr<const Sparse_pattern> m_pattern;
  std::vector<int> m_places;  // in the pattern, of the products of two entries of a row
};

/// \brief A step of a fairing
struct Fairing_step {
  Points f;               ///< positions of the vertices of the patch: of the last trial
  bool is_lower = false;  ///< it has less energy than before
};

/// a free vertex for each column, added to positions
inline Points moved(const Fairing_patch& patch, Points f, const Points& d, double t = 1)
{
  f(Eigen::indexing::all, patch.free_vertices()) += t * d;
  return f;
}

inline void require_fairing_solver(Solver_status status)
{
  if (status != Solver_status::success) throw Solver_error("conformal_fairing", to_string(status));
}

}  // namespace Conformal_geometry_processing::internal
