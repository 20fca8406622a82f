// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief The rows of a quaternionic vector that have two real degrees of freedom instead of four:
/// boundary vertices of a surface with prescribed boundary directions [CGP 5.7].
///
/// Real coordinates are numbered row by row, four or two for each. Depends on the connectivity
/// only; `Reduced_basis` contains the planes of H.
class Reduced_rows {
 public:
  Reduced_rows() = default;

  /// \param size the number of all rows \param reduced the reduced ones, in any order
  /// \throw Precondition_error if an index is not a row, or occurs twice
  Reduced_rows(int size, const std::vector<int>& reduced);

  /// Number of rows
  int size() const { return static_cast<int>(m_is_reduced.size()); }

  int size_of_reduced() const { return m_count; }

  bool is_reduced(int i) const { return m_is_reduced[at(i)] != 0; }

  /// Number of real coordinates
  int dimension() const { return m_first.empty() ? 0 : m_first.back(); }

  /// Number of coordinates of row i, 2 or 4
  int dimension(int i) const { return first(i + 1) - first(i); }

  /// First coordinate of row i
  int first(int i) const { return m_first[at(i)]; }

  friend bool operator==(const Reduced_rows& a, const Reduced_rows& b)
  {
    return a.m_is_reduced == b.m_is_reduced;
  }
  friend bool operator!=(const Reduced_rows& a, const Reduced_rows& b) { return !(a == b); }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  std::vector<char> m_is_reduced;
  std::vector<int> m_first;  // size() + 1
  int m_count = 0;
};

/// \brief The space of quaternionic vectors whose reduced rows lie in given planes of H:
/// x_i = u_i a + v_i b with real a and b and orthonormal u_i, v_i. The matrix B of [CGP 5.7].
///
/// The space is real-linear and *not* quaternionic: x q is not in it. The plane
/// { x : U x = x V } of a prescribed direction is u span(1, V) = span(1, U) u, so it is closed
/// under right multiplication by V and by no other unit: the system could be made complex only if V
/// were the same at all reduced rows up to sign, which is impossible for prescribed tangents of a
/// closed curve. Reduced systems are therefore real.
template <class FT_>
class Reduced_basis {
 public:
  using FT = FT_;
  using Plane = std::array<Quaternion<FT>, 2>;

  Reduced_basis() = default;

  /// \param size the number of all rows \param reduced the reduced ones, in any order
  /// \param planes an orthonormal basis for each of them
  /// \throw Precondition_error as `Reduced_rows`; if the numbers of reduced rows and planes differ;
  /// or if u and v are not orthonormal to 1e-12 in double precision
  Reduced_basis(int size, const std::vector<int>& reduced, const std::vector<Plane>& planes)
      : m_rows(size, reduced), m_planes(static_cast<std::size_t>(size))
  {
    if (planes.size() != reduced.size())
      throw Precondition_error("Reduced_basis", std::to_string(planes.size()) + " planes for " +
                                                    std::to_string(reduced.size()) + " rows");
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if (!is_orthonormal(planes[k]))
        throw Precondition_error("Reduced_basis", "the basis of row " + std::to_string(reduced[k]) +
                                                      " is not orthonormal");
      m_planes[static_cast<std::size_t>(reduced[k])] = planes[k];
    }
  }

  const Reduced_rows& rows() const { return m_rows; }

  /// Basis vector c of row i: u or v, or one of 1, i, j, k if the row is not reduced
  Quaternion<FT> vector(int i, int c) const
  {
    if (m_rows.is_reduced(i)) return plane(i)[static_cast<std::size_t>(c)];
    return {FT(c == 0), FT(c == 1), FT(c == 2), FT(c == 3)};
  }

  /// \brief Returns x = B c: converts real coordinates to quaternions, for all columns.
  Block<Quaternion<FT>> embed(const Block<FT>& c) const
  {
    Block<Quaternion<FT>> x(m_rows.size(), c.cols());
    for (Eigen::Index k = 0; k < c.cols(); ++k)
      for (int i = 0; i < m_rows.size(); ++i) {
        const FT* const s = &c(m_rows.first(i), k);
        x(i, k) = m_rows.is_reduced(i) ? plane(i)[0] * s[0] + plane(i)[1] * s[1]
                                       : Quaternion<FT>{s[0], s[1], s[2], s[3]};
      }
    return x;
  }

  /// \brief Returns c = B^T x, the adjoint: the coordinates of the projection to the space.
  Block<FT> coordinates(const Block<Quaternion<FT>>& x) const
  {
    Block<FT> c(m_rows.dimension(), x.cols());
    for (Eigen::Index k = 0; k < x.cols(); ++k)
      for (int i = 0; i < m_rows.size(); ++i) {
        FT* const s = &c(m_rows.first(i), k);
        const Quaternion<FT>& q = x(i, k);
        if (m_rows.is_reduced(i))
          s[0] = dot(plane(i)[0], q), s[1] = dot(plane(i)[1], q);
        else
          s[0] = q.w, s[1] = q.x, s[2] = q.y, s[3] = q.z;
      }
    return c;
  }

  /// \brief Returns B B^T x, the orthogonal projection to the space.
  Block<Quaternion<FT>> project(Block<Quaternion<FT>> x) const
  {
    for (Eigen::Index k = 0; k < x.cols(); ++k)
      for (int i = 0; i < m_rows.size(); ++i)
        if (m_rows.is_reduced(i)) {
          const auto& [u, v] = plane(i);
          x(i, k) = u * dot(u, x(i, k)) + v * dot(v, x(i, k));
        }
    return x;
  }

 private:
  const Plane& plane(int i) const { return m_planes[static_cast<std::size_t>(i)]; }

  static bool is_orthonormal(const Plane& p)
  {
    const FT tolerance = 4096 * std::numeric_limits<FT>::epsilon();
    return std::abs(squared_norm(p[0]) - 1) <= tolerance &&
           std::abs(squared_norm(p[1]) - 1) <= tolerance && std::abs(dot(p[0], p[1])) <= tolerance;
  }

  Reduced_rows m_rows;
  std::vector<Plane> m_planes;  // of all rows, for direct access
};

}  // namespace Conformal_geometry_processing::internal
