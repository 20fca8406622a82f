// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Failure_reasons.h>

#include <cstddef>
#include <string>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
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

}  // namespace Conformal_geometry_processing::internal
