// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Component_failures.h>

#include <cstddef>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

internal::Component_failures::Component_failures(std::size_t size, std::string function)
    : m_size(size), m_function(std::move(function))
{}

void internal::Component_failures::throw_if_any() const
{
  if (m_reasons.size() == 0) return;
  const std::string all =
      std::to_string(m_reasons.size()) + " of " + std::to_string(m_size) +
      " components failed (their elements are counted in each): " + m_reasons.text();
  if (m_is_of_data) throw Precondition_error(m_function, all);
  throw Solver_error(m_function, all);
}

std::string internal::Component_failures::name_of(std::size_t c, int first_vertex)
{
  return "component " + std::to_string(c) + " (from vertex " + std::to_string(first_vertex) + ")";
}

}  // namespace Conformal_geometry_processing
