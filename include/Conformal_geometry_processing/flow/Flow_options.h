// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// options of a conformal Willmore flow
struct Flow_options {
  /// how balance is kept
  enum class Balancing {
    inversion,  ///< by an exact sphere inversion after each step: converges quadratically
    potential   ///< by a term of rho, to first order [CGP 6.4.4]
  };

  /// \brief the vertex areas towards which the surface is balanced among its Moebius transforms.
  ///
  /// The Moebius transforms of a surface do not differ in curvature, so a flow without balance may
  /// drift, on tori in particular.
  enum class Balance {
    none,
    initial,    ///< the initial areas
    canonical,  ///< those of the canonical metric [CGP 4.5.3]; genus > 0
    prescribed  ///< `Flow_options::target_areas`
  };

  Flow_options() { surface.exact_conformal_class = true; }

  /// \brief what is requested of the surfaces, relative to the initial one.
  ///
  /// - `exact_conformal_class`, by default true: every step ends with the nearest surface of the
  ///   exact discrete conformal class of the initial one. Otherwise surfaces drift by the
  ///   discretisation error, also in their conformal type [CGP 6.4]. The connectivity is then that
  ///   of the intrinsic Delaunay triangulation of the initial surface; time steps begin with a
  ///   quarter of `time_step`. The way to the class leaves directions at a boundary as they are,
  ///   see `internal::Class_keeper`
  /// - `boundary`: directions, or free. Those that are kept are the first ones in every step
  /// - `exactness`: with a boundary, always the adjoint
  /// - `max_period_defect`: in one step; more is removed as far as possible, see
  ///   `internal::closed_spins()`
  /// - `mollification`: distortion is then measured on the `well_shaped_faces()` of the initial
  ///   mesh. On the exact class, edges are flipped by mollified lengths, and what is left without
  ///   area is opened, see `internal::with_opened_faces()`. Off the class, curvature and energy are
  ///   computed on the triangulation, if the direction takes a `Surface_ref`
  /// - `limits.map`: the flow stops at the last step whose map is within them
  /// - `scales.bound`: limbs, and what is behind a thin neck, become no smaller; the flow ends with
  ///   the least energy that this admits. No other part of `scales` is possible
  Spin_transformation_options surface;

  /// tau in rho = -tau H. The flow is stable for 0 < tau < 2 on every mesh; tau = 1 removes high
  /// frequencies in one step. Near the round sphere a bump of degree k is multiplied by 1 - tau (1
  /// - 2 / (k (k + 1))). The thesis writes tau = 2 tau', so its bound is tau' < 1.
  double time_step = 1;
  double min_time_step = 1e-2;  ///< backtracking stops here
  int max_steps = 100;          ///< of one `run()`

  /// whether a step that increases the energy, distorts too much, or does not close up, is repeated
  /// with half of tau; after a success tau grows by half, up to `time_step`; where that has failed,
  /// it waits for more of them
  bool backtracking = true;
  /// mean quasi-conformal error of one step; none: 1.15 on the exact conformal class, which is
  /// reached only from nearby, otherwise 1.5
  std::optional<double> max_step_distortion = std::nullopt;
  double max_step_closure = 0.1;  ///< closure residual of one step

  /// whether each step on the exact class begins with smoothing within it, see
  /// `internal::Fairing`. Without effect with a filter, which is to keep the shape, with directions
  /// that have no energy, and without backtracking
  bool fairing = true;

  /// mean quasi-conformal error of the map from the initial surface up to which surfaces on the
  /// exact class are transformed as long as smoothing goes on, which distorts them less. Where it
  /// gains nothing, or is not made, and with a bound on lengths, which leaves hardly anything to
  /// smooth, the limits are those of `surface`
  double max_spin_distortion = 1.25;

  /// \brief the `Enclosure::reduced_volume()` of a closed surface that the flow keeps or, a part of
  /// the way in each step, leads to: in (0, 1]. On the exact conformal class. Surfaces of the least
  /// energy are then shapes of vesicles; on the way to the volume it may rise. A step costs a
  /// factorization more. None: the volume is free
  std::optional<double> reduced_volume = std::nullopt;

  /// stop if the energy changes by less than this share of it in a time of 1; if it tends to zero,
  /// of a hundredth of the initial energy. On the faces of the input, where these are not those of
  /// the flow, no step leads above the least energy before by more than 1 %, the error of such
  /// faces
  double energy_tolerance = 1e-4;
  double direction_tolerance = 1e-4;  ///< stop if the constraints leave less than this share of the
                                      ///< direction, or of the curvature of a round sphere

  /// sigma > 0 removes low frequencies from the direction, which preserves the overall shape; zero:
  /// no filter. See `Curvature_filter` for the units and the order.
  double filter_weight = 0;
  int filter_order = 1;

  Balance balance = Balance::none;
  Balancing balancing = Balancing::inversion;
  Eigen::VectorXd target_areas;  ///< for `Flow_options::Balance::prescribed`, |V| positive numbers
};

/// \relates Flow_options
/// returns the options if they are in their ranges
/// \throw Precondition_error naming `function` otherwise
const Flow_options& checked(const Flow_options& o, const std::string& function);

}  // namespace Conformal_geometry_processing
