// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <optional>

namespace Conformal_geometry_processing::internal {

/// a search for spins, with what closes handles and holes
struct Relaxed_surface {
  std::optional<Period_residual> periods;
  Relaxed_scales scales;

  /// \param rho wanted, |V|, in the unit of the surface
  Relaxed_surface(Spin_transformation& transformation, const Eigen::VectorXd& rho,
                  const Scale_control& control, const Relaxed_scales_options& options)
      : scales(transformation.system(), rho, control, closing(transformation), options)
  {}

  /// goes on from spins that solve the equation of rho
  void begin_at(const Quaternion_vector<double>& lambda, const Eigen::VectorXd& rho,
                const Go_further& go_further)
  {
    scales.restart({lambda, rho, 0, 0});
    scales.go_on(go_further);
  }

  /// takes off what a finite weight has left of the periods
  void close()
  {
    const int times = 2;
    for (int i = 0; i < times && periods && scales.steps() > 0; ++i) scales.meet_few(false);
  }

  /// likewise; where that takes lengths beyond their bound, goes on with room for it
  void close_within_bound(const Go_further& go_further)
  {
    const int most_tries = 3;
    for (int i = 0; i <= most_tries; ++i) {
      const double before = scales.excess();
      close();
      if (!(scales.excess() > 1) || i == most_tries) return;
      scales.leave_room(scales.excess() - before);
      if (scales.go_on(go_further) == Relaxed_scales::End::cancelled) return;
    }
  }

 private:
  Spin_residuals closing(Spin_transformation& transformation)
  {
    const Exactness_constraints* const loops = transformation.closing();
    if (!loops) return {};
    return {&periods.emplace(transformation.system().surface(), *loops)};
  }
};

/// where a search begins
struct Closing_start {
  Quaternion_vector<double> lambda = {};  ///< empty: at the guide
  bool is_ambiguous = false;              ///< another one closes up nearly as well

  /// Vectors of the kernel solve the equation: the first step closes them to first order, the
  /// second takes off what is left. Further ones go along the kernel to where the misfit of the
  /// discretisation is least, which is not where the solution is.
  static Relaxed_scales_options few_steps()
  {
    Relaxed_scales_options options;
    options.max_steps = 2;
    return options;
  }
};

}  // namespace Conformal_geometry_processing::internal
