// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_COMPONENT_FAILURES_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_COMPONENT_FAILURES_H

#include <Conformal_geometry_processing/exceptions.h>

#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief what went wrong with the components of a mesh. All of them are tried, so that the user
/// hears of all that are in the way at once.
class Component_failures {
 public:
  /// \param size how many components there are \param function named in the exception
  Component_failures(std::size_t size, std::string function)
      : m_size(size), m_function(std::move(function))
  {}

  /// Carries out the work on component c, and keeps what this library throws.
  /// \param first_vertex the number of its first vertex, as the user counts
  template <class Work>
  void attempt(std::size_t c, int first_vertex, const Work& work)
  {
    const std::string name =
        "component " + std::to_string(c) + ", from vertex " + std::to_string(first_vertex) + ": ";
    try {
      work();
    } catch (const Precondition_error& error) {
      m_messages.push_back(name + error.message());
      m_is_of_data = true;
    } catch (const Solver_error& error) {
      m_messages.push_back(name + error.message());
    }
  }

  /// \throw Precondition_error if one was caught, else Solver_error if one was; the message names
  /// all the components that failed, in which elements have numbers of their own
  void throw_if_any() const
  {
    if (m_messages.empty()) return;
    std::string all = std::to_string(m_messages.size()) + " of " + std::to_string(m_size) +
                      " components failed (their elements are counted in each): ";
    for (std::size_t i = 0; i < m_messages.size(); ++i) all += (i > 0 ? "; " : "") + m_messages[i];
    if (m_is_of_data) throw Precondition_error(m_function, all);
    throw Solver_error(m_function, all);
  }

 private:
  std::size_t m_size;
  std::string m_function;
  std::vector<std::string> m_messages;
  bool m_is_of_data = false;
};

}  // namespace Conformal_geometry_processing

#endif
