// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Curve_options.h"

#include "conformal/io/data/Plane_curve.h"

#include <Conformal_geometry_processing/curves/Isometric_curve_flow.h>

#include <string>
#include <vector>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// The flows of all curves of a file, step by step at the same time.
class Curve_flows {
 public:
  /// one curve, and its way so far
  struct One {
    std::string name;
    CGP::Isometric_curve_flow flow;
    double initial_energy = 0;
    CGP::Curve_step_report::Stop stop = CGP::Curve_step_report::Stop::none;
    std::vector<CGP::Curve_step_report> steps;
  };

  /// \throws Failure naming the file and the curve that cannot flow
  Curve_flows(const std::vector<Plane_curve>& curves, const Curve_options& options);

  /// a step of each flow that has not stopped; whether there was one
  bool step();

  const std::vector<One>& all() const { return m_all; }

  /// The current curves
  std::vector<Plane_curve> curves() const;

  /// the steps of the flow that has made most
  std::size_t size_of_steps() const;

  /// the largest length distortion of all curves
  double length_distortion() const;

 private:
  std::vector<One> m_all;
};

}  // namespace conformal
