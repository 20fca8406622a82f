// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/vector_units/Vector_unit.h>

#include <gtest/gtest.h>

#include <vector>

namespace cgp_test {

/// Sets a vector unit during its lifetime, and restores the previous one
class On_unit {
 public:
  using Unit = Conformal_geometry_processing::internal::Vector_unit;

  explicit On_unit(Unit unit) : m_before(Conformal_geometry_processing::vector_unit())
  {
    EXPECT_TRUE(Conformal_geometry_processing::set_vector_unit(unit));
  }
  ~On_unit() { Conformal_geometry_processing::set_vector_unit(m_before); }
  On_unit(const On_unit&) = delete;
  On_unit& operator=(const On_unit&) = delete;

 private:
  Unit m_before;
};

/// those that the library and the machine have, narrowest first
inline std::vector<On_unit::Unit> units_here()
{
  using Unit = On_unit::Unit;
  std::vector<Unit> result;
  for (const Unit unit : {Unit::baseline, Unit::avx2, Unit::avx512})
    if (Conformal_geometry_processing::has_vector_unit(unit)) result.push_back(unit);
  return result;
}

/// what holds, holds on every vector unit of the machine
template <class Action>
void on_every_unit(const Action& action)
{
  for (const On_unit::Unit unit : units_here()) {
    SCOPED_TRACE(Conformal_geometry_processing::to_string(unit));
    const On_unit setting(unit);
    action();
  }
}

}  // namespace cgp_test
