// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief A part of a mesh, such as a connected component, as a separate mesh.
///
/// Unless reordered, elements keep their order: results are bitwise those of the part alone.
/// Matrices of the whole mesh are block diagonal with one block per component, so factorizations
/// and eigenvectors of the blocks can be computed for each component.
struct Mesh_component {
  Mesh_view mesh;
  std::vector<int> vertices, faces;  ///< their indices in the whole mesh
};

/// Returns the faces with a nonzero entry, and their vertices. O(|V| + |F|)
/// \param is_selected |F|
Mesh_component selected_faces(const Mesh_view& mesh, const std::vector<char>& is_selected);

/// \brief The reasons why components of a mesh failed: each reason once, with the first components
/// that failed for it and the number of the others.
///
/// A mesh may have 100,000 small components that fail for different reasons: reasons beyond the
/// first few are only counted, so that time is linear, and memory and text are bounded.
class Failure_reasons {
 public:
  /// Maximal number of reported reasons, and of names per reason
  static constexpr std::size_t max_reasons = 5, max_names = 5;

  /// \param name of the component in messages
  void add(const std::string& name, const std::string& reason);

  /// Number of failed components
  std::size_t size() const { return m_size; }

  /// `NAME, NAME and 7 more: REASON; NAME: REASON; 9 more for other reasons`, in the order of their
  /// occurrence
  std::string text() const;

 private:
  struct Group {
    std::string reason, names;
    std::size_t size;  // number of components
  };

  static std::string more(std::size_t count) { return std::to_string(count) + " more"; }

  std::vector<Group> m_groups;
  std::size_t m_size = 0;
};

/// \brief Collects the failures of the components of a mesh. All components are tried, so that all
/// failures are reported at once.
class Component_failures {
 public:
  /// \param size number of components
  /// \param function named in the exception
  Component_failures(std::size_t size, std::string function);

  /// \brief Carries out the work on component c, and records the reason if it fails.
  ///
  /// Does not catch exceptions that do not concern this component only: a solver out of memory, and
  /// exceptions that are not thrown by this library.
  /// \param first_vertex the number of its first vertex in the mesh of the user
  template <class Work>
  void attempt(std::size_t c, int first_vertex, const Work& work)
  {
    try {
      work();
    } catch (const Precondition_error& error) {
      m_reasons.add(name_of(c, first_vertex), error.message());
      m_is_of_data = true;
    } catch (const Solver_error& error) {
      if (is_out_of_memory(error)) throw;
      m_reasons.add(name_of(c, first_vertex), error.message());
    }
  }

  /// \throw Precondition_error if one was caught, otherwise Solver_error if one was; the message
  /// contains the number of failed components, and each reason with the first components that
  /// failed for it; element numbers in a reason are relative to its component
  void throw_if_any() const;

 private:
  static std::string name_of(std::size_t c, int first_vertex);

  std::size_t m_size;
  std::string m_function;
  Failure_reasons m_reasons;
  bool m_is_of_data = false;
};

/// The report of an algorithm on one component of a mesh
template <class Report>
struct Component_report {
  int first_vertex = 0;  ///< its number among the vertices of the mesh, from 0
  int size_of_vertices = 0, size_of_faces = 0;
  Report report;
};

/// \brief The reports of an algorithm that processes each component of a mesh separately, in the
/// order of their first vertices.
template <class Report>
struct [[nodiscard]] Component_reports {
  std::vector<Component_report<Report>> components;

  /// Returns whether all components succeeded
  explicit operator bool() const
  {
    return std::all_of(components.begin(), components.end(),
                       [](const auto& c) { return static_cast<bool>(c.report); });
  }
};

/// \brief the part with its vertices along the Morton curve of their positions, and its faces
/// sorted by their corners, the least of which is the first: what is near on the surface is near in
/// memory.
///
/// The order is that of the shape, so a mesh whose elements are numbered in another way becomes the
/// same mesh, bit by bit; but vertices at the same position whose neighbours are at the same
/// positions, too, keep their order. O(|V| log |V|)
/// \pre positions are finite
Mesh_component in_morton_order(const Mesh_component& part);

}  // namespace internal

/// \ingroup PkgMesh
/// Returns the components in the order of their first vertices; an isolated vertex is a component,
/// too. O(|V| + |E| + |F|)
std::vector<internal::Mesh_component> mesh_components(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing
