// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Includes headers of CGAL under the GPL, which then applies to programs that use this header.
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <CGAL/Default.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/kernel_traits.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <unordered_set>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief The spectral conformal parameterization as a method of \cgal's package Triangulated
/// Surface Mesh Parameterization: replaces `LSCM_parameterizer_3` in
/// `CGAL::Surface_mesh_parameterization::parameterize()`.
///
/// Free border; no vertices are pinned. Flattens the connected component of the given border, whose
/// variance is fixed; other borders are holes. Includes headers of \cgal under the GPL, unlike
/// `conformal_parameterization()`.
///
/// \tparam TriangleMesh_ a model of `FaceGraph`
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \cgalModels{Parameterizer_3}
template <class TriangleMesh_, class SolverTraits = Default_solver_traits>
class Spectral_conformal_parameterizer_3 {
  using Graph_traits = boost::graph_traits<TriangleMesh_>;
  using Kernel_traits = CGAL::Surface_mesh_parameterization::internal::Kernel_traits<TriangleMesh_>;

 public:
  using TriangleMesh = TriangleMesh_;
  using Triangle_mesh = TriangleMesh_;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using Point_2 = typename Kernel_traits::Kernel::Point_2;
  using Error_code = CGAL::Surface_mesh_parameterization::Error_code;

  explicit Spectral_conformal_parameterizer_3(const Parameterization_options& options = {})
      : m_options(options)
  {
    m_options.solvers = SolverTraits();
  }

  /// \param border on the border of the component that is flattened
  /// \param uv receives the points; unchanged unless the result is `OK`
  /// \param number an index of each vertex of the component, from 0
  /// \param is_parameterized receives `true` for each of them
  /// \returns `ERROR_EMPTY_MESH` if there is no border or no face, `ERROR_NON_TRIANGULAR_MESH`,
  /// `ERROR_WRONG_PARAMETER` if the component is not a manifold or has a face of area zero,
  /// `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM` if the map was not found
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const TriangleMesh& mesh, halfedge_descriptor border, VertexUVMap uv,
                          VertexIndexMap number, VertexParameterizedMap is_parameterized)
  {
    namespace SMP = CGAL::Surface_mesh_parameterization;
    if (border == Graph_traits::null_halfedge() || !CGAL::is_border(border, mesh) ||
        CGAL::is_border(opposite(border, mesh), mesh))
      return SMP::ERROR_EMPTY_MESH;
    Component component(mesh, border, number);
    if (!component.is_triangulated) return SMP::ERROR_NON_TRIANGULAR_MESH;
    try {
      const Mesh_view view(component.positions(mesh), std::move(component.corners));
      require_surface(view, "Spectral_conformal_parameterizer_3");
      const internal::Parameterization_result result = spectral_parameterization_of(
          view, {loop(mesh, border, number)}, m_options, "Spectral_conformal_parameterizer_3");
      if (!result.report) return SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
      for (std::size_t i = 0; i < component.vertices.size(); ++i) {
        const std::complex<double>& z = result.z[static_cast<Eigen::Index>(i)];
        put(uv, component.vertices[i], Point_2(z.real(), z.imag()));
        put(is_parameterized, component.vertices[i], true);
      }
    } catch (const Precondition_error&) {
      return SMP::ERROR_WRONG_PARAMETER;
    } catch (const Solver_error&) {
      return SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    }
    return SMP::OK;
  }

 private:
  /// The faces of the connected component of a border, and their vertices by index
  struct Component {
    template <class VertexIndexMap>
    Component(const TriangleMesh& mesh, halfedge_descriptor border, VertexIndexMap number)
    {
      std::unordered_set<typename Graph_traits::face_descriptor> seen;
      std::vector<halfedge_descriptor> waiting = {opposite(border, mesh)};
      seen.insert(face(waiting.back(), mesh));
      while (!waiting.empty()) {
        const halfedge_descriptor h = waiting.back();
        waiting.pop_back();
        add_face(mesh, h, number);
        for (const halfedge_descriptor g : CGAL::halfedges_around_face(h, mesh)) {
          const halfedge_descriptor other = opposite(g, mesh);
          if (!CGAL::is_border(other, mesh) && seen.insert(face(other, mesh)).second)
            waiting.push_back(other);
        }
      }
    }

    template <class VertexIndexMap>
    void add_face(const TriangleMesh& mesh, halfedge_descriptor h, VertexIndexMap number)
    {
      is_triangulated = is_triangulated && next(next(next(h, mesh), mesh), mesh) == h;
      std::array<int, 3> face;
      for (int& corner : face) {
        corner = static_cast<int>(get(number, target(h, mesh)));
        const auto i = static_cast<std::size_t>(corner);
        if (vertices.size() <= i) vertices.resize(i + 1, Graph_traits::null_vertex());
        vertices[i] = target(h, mesh);
        h = next(h, mesh);
      }
      corners.push_back(face);
    }

    Points positions(const TriangleMesh& mesh) const
    {
      const auto points = get(CGAL::vertex_point, mesh);
      Points p(3, static_cast<Eigen::Index>(vertices.size()));
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto& q = get(points, vertices[i]);
        p.col(static_cast<Eigen::Index>(i)) << CGAL::to_double(q.x()), CGAL::to_double(q.y()),
            CGAL::to_double(q.z());
      }
      return p;
    }

    bool is_triangulated = true;
    std::vector<vertex_descriptor> vertices;
    Mesh_view::Corners corners;
  };

  /// Returns the vertices along a border, which runs with the surface on its right
  template <class VertexIndexMap>
  static internal::Vertex_loop loop(const TriangleMesh& mesh, halfedge_descriptor border,
                                    VertexIndexMap number)
  {
    internal::Vertex_loop loop;
    for (halfedge_descriptor h = border;;) {
      loop.push_back(static_cast<int>(get(number, target(h, mesh))));
      h = prev(h, mesh);
      if (h == border) return loop;
    }
  }

  Parameterization_options m_options;
};

}  // namespace Conformal_geometry_processing
