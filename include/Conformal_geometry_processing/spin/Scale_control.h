// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing::internal {

/// the bound on factors of lengths, in the library, the program, Python and the studio, unless the
/// caller gives another one
inline constexpr double default_scale_bound = 2;

/// the same relative to wanted factors: these are mostly within a factor of 2 of the present
/// lengths, so with a bound of 2 nothing would change
inline constexpr double default_bound_of_wanted_scales = 1.25;

/// \brief how much a transformation may change lengths.
struct Scale_control {
  /// > 1: lengths are multiplied by factors in [1 / bound, bound], relative to `factors`, on 98 %
  /// of the weighted area, and 1.5 times the bound holds on 99.8 %: tips are more. The total area
  /// is kept. None: rho is applied as it is
  std::optional<double> bound = std::nullopt;
  Eigen::VectorXd factors = {};  ///< wanted, |V|, positive; empty: 1 everywhere
  Eigen::VectorXd weights = {};  ///< |V|, of the areas; 0: lengths may change freely. Empty: 1
  /// |V|, whose shares of 98 % and 99.8 % are meant; empty: those of the surface. In a flow those
  /// of its start, or what has shrunk would not count
  Eigen::VectorXd counted_areas = {};

  /// \throw Precondition_error naming the first vertex with an unsuitable value, or if there are
  /// factors or weights but no bound
  void require(Eigen::Index vertices, const std::string& function) const;
};

/// the bound, and the factors by which spins multiply lengths
/// \param areas |V|, of the vertices
Spin_report::Scales measured_scales(const Quaternion_vector<double>& lambda,
                                    const Eigen::VectorXd& areas, const Scale_control& control,
                                    const Surface_part& part = {});

/// the logarithms of the wanted factors of lengths, |V|; zeros where none are wanted
Eigen::VectorXd wanted_log_scales(const Eigen::VectorXd& areas, const Scale_control& control);

/// what is kept of rho
/// \param areas that belong to the values
/// \param is_closed: both are taken without their means, which have no effect then
void measure_kept(const Eigen::VectorXd& rho, const Eigen::VectorXd& found,
                  const Eigen::VectorXd& areas, bool is_closed, Spin_report::Scales& scales,
                  const Surface_part& part = {});

}  // namespace Conformal_geometry_processing::internal
