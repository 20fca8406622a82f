// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>

namespace Conformal_geometry_processing {

internal::Reduced_rows::Reduced_rows(int size, const std::vector<int>& reduced)
    : m_is_reduced(at(size), 0), m_count(static_cast<int>(reduced.size()))
{
  for (int i : reduced) {
    if (i < 0 || i >= size)
      throw Precondition_error("Reduced_rows", "row " + std::to_string(i) + " is not one of " +
                                                   std::to_string(size) + " rows");
    if (is_reduced(i))
      throw Precondition_error("Reduced_rows", "row " + std::to_string(i) + " is named twice");
    m_is_reduced[at(i)] = 1;
  }
  m_first.reserve(at(size) + 1);
  m_first.push_back(0);
  for (int i = 0; i < size; ++i) m_first.push_back(first(i) + (is_reduced(i) ? 2 : 4));
}

}  // namespace Conformal_geometry_processing
