// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_FLOW_OPTIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_FLOW_OPTIONS_H

#include <Conformal_geometry_processing/spin/Dirac_solution.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// how to run a conformal Willmore flow
struct Flow_options {
  /// tau in rho = -tau H. The flow is stable for 0 < tau < 2 on every mesh; tau = 1 takes high
  /// frequencies away in one step. Near the round sphere a bump of degree k is multiplied by
  /// 1 - tau (1 - 2 / (k (k + 1))). The thesis writes tau = 2 tau', so its bound is tau' < 1.
  double time_step = 1;
  double min_time_step = 1e-2;  ///< backing off stops here
  int max_steps = 100;          ///< of one `run()`

  /// whether a step that raises the energy, or distorts too much, is tried again with half of tau;
  /// after a success tau grows by half, up to `time_step`
  bool backtracking = true;
  double max_step_distortion = 1.5;  ///< mean quasi-conformal error of one step

  double energy_tolerance = 1e-4;  ///< stop where the energy changes by less than this share of it
                                   ///< in a time of 1
  double direction_tolerance = 1e-4;  ///< stop where the constraints leave less than this share of
                                      ///< the direction

  Dirac_options dirac;
};

}  // namespace Conformal_geometry_processing

#endif
