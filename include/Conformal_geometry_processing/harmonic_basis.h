// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Conformal_mesh_traits.h>
#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief The harmonic 1-forms of a mesh and their tangent fields, as property maps of its
/// halfedges and faces: the result of `harmonic_basis()`.
///
/// A value type; copies and maps share the numbers and keep them alive. They do not refer to the
/// mesh, which may be changed or destroyed. Maps remain valid for the elements that the mesh had,
/// and throw `Precondition_error` for unknown ones. Each access costs a hash table look-up.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam Vector_ constructed from three numbers
template <class TriangleMesh, class Vector_>
class Harmonic_forms {
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  struct Data;

 public:
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Vector = Vector_;

  /// A model of `ReadablePropertyMap`
  template <class Key, class Value>
  using Map = boost::function_property_map<std::function<Value(const Key&)>, Key, Value>;

  /// \param mesh is only read, and not stored \param graph its view
  /// \param basis of that view, or of one that is larger by `scale`
  Harmonic_forms(const TriangleMesh& mesh, const Graph_view<TriangleMesh>& graph,
                 Harmonic_basis basis, double scale = 1)
      : m_data(std::make_shared<const Data>(mesh, graph, std::move(basis), scale))
  {}

  /// 2 `genus()`, and with a boundary one more for each of its loops but one
  int size() const { return static_cast<int>(m_data->fields.size()); }
  int genus() const { return m_data->genus; }

  /// \brief Form i, 0 <= i < `size()`: its integral along each halfedge, dimensionless; opposite
  /// halfedges have opposite values. The sum of w_e omega_i(e) omega_j(e) over the edges, with
  /// cotan weights, is 1 for i = j and 0 otherwise.
  Map<halfedge_descriptor, double> one_form(int i) const
  {
    return {[data = m_data, i](const halfedge_descriptor& h) {
      return data->along_halfedges(static_cast<Eigen::Index>(data->halfedges(h)), i);
    }};
  }

  /// \brief The vector in the plane of each face that represents form i along its edges, in
  /// 1/length of the mesh. The sum of A_f <v_i, v_j> over the faces equals the inner product of the
  /// forms.
  Map<face_descriptor, Vector> tangent_field(int i) const
  {
    return {[data = m_data, i](const face_descriptor& f) {
      const auto v =
          data->fields[static_cast<std::size_t>(i)].col(static_cast<Eigen::Index>(data->faces(f)));
      return Vector(v.x(), v.y(), v.z());
    }};
  }

 private:
  struct Data {
    Data(const TriangleMesh& mesh, const Graph_view<TriangleMesh>& graph, Harmonic_basis basis,
         double scale)
        : genus(topology(graph.view()).genus),
          halfedges(halfedges_of(mesh, graph)),
          faces(faces_of(graph)),
          along_halfedges(values_along(graph.view(), basis)),
          fields(std::move(basis.fields))
    {
      for (Points& v : fields) v *= scale;
    }

    /// In the order of the view, whose halfedge 3 f + c is opposite corner c; border halfedges are
    /// last
    static std::vector<halfedge_descriptor> halfedges_of(const TriangleMesh& mesh,
                                                         const Graph_view<TriangleMesh>& graph)
    {
      std::vector<halfedge_descriptor> list;
      for (int f = 0; f < graph.view().size_of_faces(); ++f) {
        const auto last = halfedge(graph.face(f), mesh);  // from corner 0 to corner 1
        const auto first = next(last, mesh);
        list.insert(list.end(), {first, next(first, mesh), last});
      }
      for (int h = 0; h < graph.view().size_of_halfedges(); ++h)
        if (graph.view().twin(h) < 0)
          list.push_back(opposite(list[static_cast<std::size_t>(h)], mesh));
      return list;
    }

    /// In the order of `halfedges_of()`
    static Eigen::MatrixXd values_along(const Mesh_view& view, const Harmonic_basis& basis)
    {
      std::vector<int> border;
      for (int h = 0; h < view.size_of_halfedges(); ++h)
        if (view.twin(h) < 0) border.push_back(h);
      const int inside = view.size_of_halfedges(), all = inside + static_cast<int>(border.size());
      Eigen::MatrixXd values(all, basis.size());
      for (int i = 0; i < basis.size(); ++i) {
        for (int h = 0; h < inside; ++h)
          values(h, i) = along_halfedge(view, basis.one_forms.col(i), h);
        for (int h = inside; h < all; ++h)
          values(h, i) = -values(border[static_cast<std::size_t>(h - inside)], i);
      }
      return values;
    }

    static std::vector<face_descriptor> faces_of(const Graph_view<TriangleMesh>& graph)
    {
      std::vector<face_descriptor> list;
      for (int f = 0; f < graph.view().size_of_faces(); ++f) list.push_back(graph.face(f));
      return list;
    }

    int genus;
    Element_numbering<halfedge_descriptor> halfedges;
    Element_numbering<face_descriptor> faces;
    Eigen::MatrixXd along_halfedges;  // number of halfedges x number of forms
    std::vector<Points> fields;       // each 3 x |F|
  };

  std::shared_ptr<const Data> m_data;
};

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief Computes the harmonic 1-forms of a surface and their tangent fields, orthonormal: 2G of
/// them for genus G, and 2G + L - 1 with L boundary loops [CGP 6.4.5.1].
///
/// Harmonic forms are closed and co-closed: they integrate to zero around each face, and their
/// weighted sum around each vertex is zero. At a boundary their fields are therefore tangent to it
/// (forms of Neumann type). They represent the cohomology of the surface: directions along its
/// handles and around its holes. Spheres and disks have none.
///
/// Computes in double precision for any kernel. Takes one factorization of the Laplacian and two
/// solves per form. The orthonormal basis depends on the order of the vertices and faces.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \param mesh the surface
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map, geom_traits}
///     \cgalParamDescription{see `conformal_parameterization()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_solver}
///     \cgalParamDescription{the linear solver; only its type matters, not its value}
///     \cgalParamType{a model of `SparseHermitianSolverTraits`}
///     \cgalParamDefault{`Default_solver_traits`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the forms; vectors are those of the kernel of the points, or Eigen's if they have none
/// \throw Precondition_error if the mesh is not a connected, oriented triangle mesh with finite
/// coordinates and positive areas; the message names the element
/// \throw Solver_error if the Laplacian cannot be factored
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
auto harmonic_basis(const TriangleMesh& mesh,
                    const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::only_known_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                                                CGAL::internal_np::geom_traits_t,
                                                internal_np::sparse_solver_t>,
                "harmonic_basis(): unknown named parameter, see the manual for those it accepts");
  using Vector = internal::Vector_of<internal::Point_of<TriangleMesh, NamedParameters>>;
  const std::string function = "harmonic_basis";

  const Graph_view<TriangleMesh> graph(mesh, np, function);
  require_not_empty(graph.view(), function);
  require_finite_positions(graph.view(), function);
  const internal::Normalized_frame frame(graph.view().positions());
  Mesh_view view = graph.view();
  view.set_positions(frame.to_frame(view.positions()));
  Harmonic_basis basis =
      Hodge_decomposition(view, function, internal::spin_solvers(np)).harmonic_basis();
  return internal::Harmonic_forms<TriangleMesh, Vector>(mesh, graph, std::move(basis),
                                                        1 / frame.unit());
}

}  // namespace Conformal_geometry_processing
