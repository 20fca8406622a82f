// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

namespace Conformal_geometry_processing::internal {

/// \brief the space of changes of spins lambda: that of the system, without right factors of
/// lambda, quaternions on closed surfaces and real numbers where directions are prescribed. They
/// have no effect on the shape. A free boundary has no gauge: there lambda is near to 1.
class Spin_gauge {
 public:
  using Spins = Quaternion_vector<double>;

  /// \param system must outlive the object
  explicit Spin_gauge(const Dirac_system& system)
      : m_system(system), m_is_free(!system.is_closed() && !system.directions())
  {}

  bool is_free() const { return m_is_free; }  ///< no gauge

  /// with mean |lambda|^2 = 1, where that is gauge
  Spins normalized(Spins lambda) const;

  /// the nearest change, with respect to the areas
  Spins projected(const Spins& lambda, Spins y) const;

  /// the transpose: a gradient that knows nothing of what is left out
  Spins projected_gradient(const Spins& lambda, Spins g) const;

 private:
  const Dirac_system& m_system;
  bool m_is_free;
};

}  // namespace Conformal_geometry_processing::internal
