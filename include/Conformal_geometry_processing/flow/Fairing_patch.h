// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief A region of a surface that is to be replaced, with as much of its surroundings as
/// determines the normals at its rim.
///
/// A vertex is free if all faces around it belong to the region, and none of them touches the
/// boundary of the mesh: there, the first row of faces stays, because it carries the normals. The
/// surface bends at the free vertices and at their neighbours; those that are not free are the rim.
/// The patch consists of the faces around all of these, so each of them has its complete ring.
class Fairing_patch {
 public:
  /// \param mesh with finite positions and manifold
  /// \param is_in_region one entry for each face
  /// \throw Precondition_error if there is no free vertex, a component of the surface has no rim,
  /// or a face of the patch has area zero
  Fairing_patch(const Mesh_view& mesh, const std::vector<char>& is_in_region,
                const std::string& function);

  /// the faces around all vertices where the surface bends
  const Mesh_view& mesh() const { return m_part.mesh; }

  /// the indices of the vertices of the patch in the whole mesh
  const std::vector<int>& vertices() const { return m_part.vertices; }

  /// the number of free vertices
  int size() const { return static_cast<int>(m_free.size()); }

  /// the free vertex k, in the patch
  int free_vertex(int k) const { return m_free[static_cast<std::size_t>(k)]; }

  const std::vector<int>& free_vertices() const { return m_free; }

  /// which free vertex v is; -1 if it is held
  int unknown(int v) const { return m_unknowns[static_cast<std::size_t>(v)]; }
  const std::vector<int>& unknowns() const { return m_unknowns; }

  bool is_free(int v) const { return unknown(v) >= 0; }

  /// whether v or a neighbour is free
  bool bends(int v) const { return m_bends[static_cast<std::size_t>(v)] != 0; }

  /// whether face f moves: one of its corners is free
  bool moves(int f) const;

  /// whether face f of the patch belongs to the region
  bool is_in_region(int f) const { return m_is_in_region[static_cast<std::size_t>(f)] != 0; }

 private:
  std::vector<char> find_free(const Mesh_view& mesh, std::vector<char> is_in_region) const;
  void require_rim(const std::string& function) const;
  void require_areas(const std::string& function) const;

  Mesh_component m_part;
  std::vector<int> m_free, m_unknowns;
  std::vector<char> m_bends, m_is_in_region;
};

/// \brief The largest, and the root mean square, angle between the normals of a surface inside and
/// outside of a region, at its rim, in radians.
///
/// At each vertex of the rim, angle-weighted normals of the faces that move, and of those outside
/// of the region. Of smooth surfaces they differ by O(h), as the edges are long.
struct Normal_jump {
  double max = 0, rms = 0;
};

/// \param f positions of the vertices of the patch
Normal_jump normal_jump(const Fairing_patch& patch, const Points& f);

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
