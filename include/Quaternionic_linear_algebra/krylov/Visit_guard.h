// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/exceptions.h>

#include <string>

namespace Conformal_geometry_processing::internal {

/// \brief Member of an object that calls a visitor while its work is half done: refuses the calls
/// by which that visitor would start other work on the same object.
class Visit_guard {
 public:
  Visit_guard() = default;

  // A copy of an object has no visitor.
  Visit_guard(const Visit_guard&) {}
  Visit_guard& operator=(const Visit_guard&) { return *this; }

  /// \throw Precondition_error if a visitor of the object is being called
  void require_no_visit(const std::string& function) const
  {
    if (m_is_visited)
      throw Precondition_error(function,
                               "called by its own visitor: an object that computes cannot start "
                               "another computation; use a second object, or wait for the result");
  }

  /// Returns what `call()`, which calls the visitor, returns
  template <class Call>
  auto during(Call&& call)
  {
    const Visit visit(m_is_visited);
    return call();
  }

  /// `go_further`, called as a visitor. Both must outlive the result.
  template <class GoFurther>
  auto guarded(const GoFurther& go_further)
  {
    return [this, &go_further](const auto& progress) {
      return this->during([&] { return go_further(progress); });
    };
  }

 private:
  // Visits may be nested where the work of one function is a part of another's.
  class Visit {
   public:
    explicit Visit(bool& is_visited) : m_is_visited(is_visited), m_before(is_visited)
    {
      m_is_visited = true;
    }
    ~Visit() { m_is_visited = m_before; }
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

   private:
    bool& m_is_visited;
    bool m_before;
  };

  bool m_is_visited = false;
};

}  // namespace Conformal_geometry_processing::internal
