// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <cmath>
#include <iosfwd>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief the numbers that verify one step of a flow.
struct [[nodiscard]] Flow_step_report {
  /// why a flow has stopped
  enum class Stop {
    none,                 ///< it has not stopped: it can continue
    energy_settled,       ///< the energy changes by less than the tolerance
    direction_vanished,   ///< the constraints leave less of the direction than the tolerance
    steps_done,           ///< the requested number of steps is done
    cancelled,            ///< the visitor cancelled
    time_step_too_small,  ///< no step of at least `min_time_step` is acceptable
    limits_reached,       ///< a step of `min_time_step`, without backtracking the next one, would
                          ///< exceed `Flow_options::limits`
    scale_range,          ///< no step is acceptable, and limbs have shrunk to the limit of `double`
                          ///< on the exact conformal class
    step_failed           ///< no step could be computed, or a step was rejected and backtracking is
                          ///< off
  };

  /// where a trial was rejected
  struct Place {
    int vertex = -1;   ///< where the reason is largest; -1: at no single place
    int face = -1;     ///< the face of the input there that has the least angle
    double angle = 0;  ///< this angle, in radians: nearly zero in slivers
  };

  int step = 0;            ///< its number, from 1
  bool accepted = false;   ///< the surface has moved
  Stop stop = Stop::none;  ///< why the flow must stop after this step, if it must
  std::string message;     ///< why the last trial was rejected, if it was
  Place place;             ///< and where

  double energy_before = 0, energy = 0;  ///< of the direction; Willmore energy if it has none
  double energy_of_faces = 0;            ///< likewise after the step, on the faces of the input
  bool is_bounded = false;               ///< rho was changed so that lengths keep to their bound
  bool faired = false;                   ///< the surface was smoothed within its conformal class
  double time_step = 0;                  ///< tau of the last trial; zero if only fairing succeeded
  int trials = 0;                        ///< how many time steps were tried
  double direction_norm = 0;             ///< root of the integral of v^2, after projection
  double direction_norm_after = 0;       ///< likewise after the step, where a surface on its exact
                                         ///< class keeps directions at its boundary
  double remaining_share = 0;            ///< of the direction, after projection
  double period_defect = 0;  ///< harmonic part of the new edges, relative; zero without loops
  Spin_report spin;  ///< the spin transformation of the last trial, with its distortion, and the
                     ///< costs of all trials
  internal::Distribution quasi_conformal;  ///< from the initial surface to the present one
  double length_cross_ratio = 0;           ///< largest change of the logarithms, likewise
  double seconds = 0;                      ///< wall clock, all trials together
};

/// \relates Flow_report
/// the reason in words
const char* to_string(Flow_step_report::Stop stop);

/// \relates Flow_report
/// ", most at vertex 12, where face 34 has an angle of 0.5 degrees"; empty if it is at no single
/// place
std::string to_string(const Flow_step_report::Place& place);

/// \ingroup PkgFlow
/// \brief the numbers that verify a whole flow.
struct [[nodiscard]] Flow_report {
  Flow_step_report::Stop stop = Flow_step_report::Stop::none;
  std::string message;                    ///< why the last trial was rejected, if it was
  Flow_step_report::Place place;          ///< and where
  std::vector<Flow_step_report> steps;    ///< the accepted ones
  double initial_energy = 0, energy = 0;  ///< on the faces of the flow
  Conformality conformality;  ///< of the map from the initial surface to the last one, likewise

  /// \name On the faces of the input
  /// What a user gets: these differ on the exact conformal class, where the faces of the input may
  /// be slivers that the intrinsic Delaunay triangulation does not have.
  ///@{
  double initial_energy_of_faces = 0, energy_of_faces = 0;
  Conformality conformality_of_faces;
  ///@}

  /// of a closed surface, on the faces of the input; zero with a boundary
  Enclosure initial_enclosure, enclosure;

  /// the logarithm of the prescribed reduced volume by that of the last surface; zero without any
  double missing_volume = 0;

  /// \brief what the constraints leave of the direction on the last surface, where a surface on its
  /// exact class keeps directions at its boundary: the root of the integral of its square.
  ///
  /// With binormals, these are the constants and what closes the surface around its holes: the mean
  /// curvature is constant, or the flow stationary only because of them, where this is small.
  double direction_norm = 0;

  /// the factors by which lengths have changed, with a bound on them: see
  /// `Flow_options::scale_bound`
  Spin_report::Scales scales;
  int bounded_steps = 0;  ///< of which rho was changed so that lengths keep to the bound

  /// change of the conformal type of a closed surface with handles, measured by its harmonic forms,
  /// see `internal::conformal_type_distance()`
  double conformal_type_change = 0;

  /// sum of the period defects of the steps: how far the edges were from closing up in all. On the
  /// exact class, to which each step returns, the largest of them
  double period_defect = 0;
  double seconds = 0;  ///< wall clock

  /// beyond this change of type the surfaces are not called conformally equivalent
  static constexpr double max_conformal_type_change = 0.1;

  /// and beyond this period defect the surface was sheared to close up
  static constexpr double max_period_defect = 0.1;

  /// whether both are within their bounds
  bool keeps_conformal_type() const
  {
    return conformal_type_change <= max_conformal_type_change && period_defect <= max_period_defect;
  }

  /// whether the flow has converged
  bool converged() const;

  /// up to which it counts as reached
  static constexpr double max_missing_volume = 1e-3;

  /// whether it did what was asked: it has converged, or made the requested number of steps, and
  /// reached the prescribed volume
  bool is_complete() const
  {
    return (converged() || stop == Flow_step_report::Stop::steps_done) && has_volume();
  }

  /// whether it has the prescribed volume, if there is one
  bool has_volume() const { return std::abs(missing_volume) <= max_missing_volume; }

  /// which limit of a conformal map from start to end is exceeded, on the faces of the input or
  /// those of the flow
  Conformality::Fault map_fault() const
  {
    const Conformality::Fault fault = conformality_of_faces.fault({});
    return fault != Conformality::Fault::none ? fault : conformality.fault({});
  }

  /// whether it is complete, conformal from start to end, and `keeps_conformal_type()`
  explicit operator bool() const
  {
    return is_complete() && map_fault() == Conformality::Fault::none && keeps_conformal_type();
  }
};

/// \relates Flow_report
/// \brief appends a step if it was accepted, and copies its reason to stop.
/// \returns whether it was accepted
bool append(Flow_report& report, Flow_step_report step);

/// \relates Flow_report
/// writes the numbers of a flow, one fact per line, and why it is not a success, if it is none
std::ostream& operator<<(std::ostream& out, const Flow_report& r);

/// \ingroup PkgFlow
/// \brief a model of `FlowVisitor` that does nothing; derive from it to override a function.
///
/// Its exceptions are propagated; the flow then remains at its last complete step.
struct Flow_visitor {
  /// called once, with the initial surface and its energy
  void on_flow_begin(const Mesh_view&, double) {}

  /// called before every iteration of the eigensolver
  void on_iteration(const Eigensolver_progress&) {}

  /// called before every step and after every iteration: false stops the flow at the last complete
  /// step
  bool go_further() { return true; }

  /// called after every accepted step, with the new surface
  void on_step_end(const Flow_step_report&, const Mesh_view&) {}
};

}  // namespace Conformal_geometry_processing
