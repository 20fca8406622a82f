// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \brief which of a surface is counted, and how the numbers of several parts become those of the
/// whole: with one, what measures a surface measures one whose parts are in several processes.
///
/// By default, a surface in one part. A part has all faces around its own vertices, so that what is
/// computed there is right, and its own vertices and faces come first. Values at the other vertices
/// are those of their owners; sums over vertices, such as areas and gradients, are zero there, so
/// that a product of both is that of the own vertices.
struct Surface_part {
  int vertices = (std::numeric_limits<int>::max)(), faces = vertices;  ///< own ones, or all
  std::function<bool(int edge)> is_own_edge = {};
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> sum_of_parts = {};
  std::function<double(double)> largest_of_parts = {};
  std::function<void(Eigen::MatrixXd&)> take_from_owners = {};  ///< a column for each vertex

  int own_vertices(Eigen::Index all) const { return (std::min)(vertices, static_cast<int>(all)); }
  int own_faces(Eigen::Index all) const { return (std::min)(faces, static_cast<int>(all)); }
  bool counts(int edge) const { return !is_own_edge || is_own_edge(edge); }

  /// of each coefficient
  Eigen::VectorXd sum(const Eigen::VectorXd& own) const
  {
    return sum_of_parts ? sum_of_parts(own) : own;
  }
  double sum(double own) const { return sum(Eigen::VectorXd::Constant(1, own))[0]; }

  /// the largest coefficient, -infinity if there is none
  double largest(const Eigen::VectorXd& own) const
  {
    const double most = own.size() > 0 ? own.maxCoeff() : -HUGE_VAL;
    return largest_of_parts ? largest_of_parts(most) : most;
  }
  double smallest(const Eigen::VectorXd& own) const { return -largest(-own); }

  /// replaces values at other vertices, a column for each vertex, by those of their owners
  template <class Values>
  void complete(Values&& values) const
  {
    if (!take_from_owners) return;
    Eigen::MatrixXd all = values;
    take_from_owners(all);
    values = all;
  }

  /// sets sums at other vertices, a row for each vertex, to zero
  template <class Sums>
  void clear_others(Sums&& sums) const
  {
    const Eigen::Index others = sums.rows() - own_vertices(sums.rows());
    sums.bottomRows(others).setConstant(typename std::decay_t<Sums>::Scalar{});
  }
};

}  // namespace internal

/// \ingroup PkgMesh
/// \brief a reference to any model of `ConformalSurface`: the parameter type of the operators,
/// which are compiled once for all models.
///
/// Converts from `Mesh_view`, `Delaunay_view` or a user-defined model. Copying costs as much as
/// copying three pointers; accessing a sheet costs one indirect call. The surface must outlive the
/// reference.
class Surface_ref {
 public:
  template <class Surface, class = decltype(std::declval<const Surface&>().sheet(0).share),
            class = decltype(std::declval<const Surface&>().ends())>
  Surface_ref(const Surface& surface)
      : m_surface(&surface),
        m_functions(&functions<Surface>),
        m_positions(&surface.positions()),
        m_ends(&surface.ends())
  {}

  const Points& positions() const { return *m_positions; }
  Eigen::Vector3d position(int v) const { return m_positions->col(v); }
  int size_of_vertices() const { return static_cast<int>(m_positions->cols()); }

  /// number of faces of the mesh
  int size_of_faces() const { return m_functions->size_of_faces(m_surface); }

  int size_of_edges() const { return static_cast<int>(m_ends->size()); }

  /// the ends of edge k, the smaller number first
  const std::array<int, 2>& ends(int k) const { return (*m_ends)[static_cast<std::size_t>(k)]; }

  int size_of_sheets() const { return m_functions->size_of_sheets(m_surface); }
  Sheet sheet(int i) const { return m_functions->sheet(m_surface, i); }

  /// see `boundary_loops()`
  std::vector<std::vector<int>> loops() const { return m_functions->loops(m_surface); }

 private:
  struct Functions {
    int (*size_of_faces)(const void*);
    int (*size_of_sheets)(const void*);
    Sheet (*sheet)(const void*, int);
    std::vector<std::vector<int>> (*loops)(const void*);
  };

  template <class Surface>
  static const Surface& as(const void* surface)
  {
    return *static_cast<const Surface*>(surface);
  }

  template <class Surface>
  static constexpr Functions functions = {
      [](const void* s) { return as<Surface>(s).size_of_faces(); },
      [](const void* s) { return as<Surface>(s).size_of_sheets(); },
      [](const void* s, int i) { return as<Surface>(s).sheet(i); },
      [](const void* s) { return boundary_loops(as<Surface>(s)); }};

  const void* m_surface;
  const Functions* m_functions;
  const Points* m_positions;
  const std::vector<std::array<int, 2>>* m_ends;
};

/// \ingroup PkgMesh
/// the boundary loops of the referenced surface
inline std::vector<std::vector<int>> boundary_loops(const Surface_ref& surface)
{
  return surface.loops();
}

/// \ingroup PkgMesh
/// for each vertex, whether it lies on the boundary
inline std::vector<char> boundary_vertices(const Surface_ref& surface)
{
  std::vector<char> is_boundary(static_cast<std::size_t>(surface.size_of_vertices()), 0);
  for (const std::vector<int>& loop : surface.loops())
    for (const int v : loop) is_boundary[static_cast<std::size_t>(v)] = 1;
  return is_boundary;
}

/// \ingroup PkgMesh
/// the mean length h of the edges
/// \pre there is an edge
double mean_edge_length(const Surface_ref& surface, const internal::Surface_part& part = {});

}  // namespace Conformal_geometry_processing
