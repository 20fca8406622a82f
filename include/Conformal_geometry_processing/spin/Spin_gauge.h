// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief fixes the gauge of an eigenvector lambda, a right factor: makes its mean real and
/// positive and the mean of |lambda|^2 one.
///
/// A constant lambda thus becomes 1, and the surface as a whole neither turns nor grows. If the
/// mean vanishes (it has no direction), the largest value is made real instead.
/// \param areas the weights of the mean, |V| positive numbers
void fix_gauge(Quaternion_vector<double>& lambda, const Eigen::VectorXd& areas);

namespace internal {

Eigen::Vector3d centroid(const Mesh_view& mesh, const Points& f, const Eigen::VectorXd& areas);

}  // namespace internal

/// \ingroup PkgSpin
/// \brief scales new positions f, and the spins that led to them, so that the area is that of the
/// mesh, and moves the centroid to that of the mesh.
void restore_area(const Mesh_view& mesh, Points& f, Quaternion_vector<double>& lambda);

namespace internal {

/// \ingroup PkgSpin
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

}  // namespace internal

}  // namespace Conformal_geometry_processing
