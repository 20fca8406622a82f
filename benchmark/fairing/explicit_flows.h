// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include "Fairing_flow.h"
#include "laplacian.h"

namespace cgp_benchmark {

/// \brief f <- f - tau / 2 M^-1 L f, the mean curvature flow df/dt = -H N [Bra92].
///
/// Spheres shrink as dR/dt = -1 / R. Stable for tau < 4 / (greatest eigenvalue of M^-1 L), which is
/// of second order in the shortest edge.
class Explicit_mean_curvature : public Flow_of_positions {
 public:
  using Flow_of_positions::Flow_of_positions;

  bool step() override
  {
    const Eigen::VectorXd inverse = CGP::voronoi_areas(mesh()).cwiseInverse();
    const CGP::Points& f = mesh().positions();
    const CGP::Points Lf = laplacian(mesh(), CGP::cotan_weights(mesh()), f);
    set_positions(f - time_step() / 2 * weighted(inverse, Lf));
    return true;
  }
};

/// \brief f <- f - tau / 2 (M^-1 L)^2 f, the flow of the bi-Laplacian df/dt = -Delta^2 f / 2
/// [Tau95].
///
/// Spheres shrink as dR/dt = -2 / R^3. Stable for tau < 4 / (greatest eigenvalue of M^-1 L)^2, of
/// fourth order in the shortest edge.
class Explicit_bi_laplacian : public Flow_of_positions {
 public:
  using Flow_of_positions::Flow_of_positions;

  bool step() override
  {
    const Eigen::VectorXd w = CGP::cotan_weights(mesh());
    const Eigen::VectorXd inverse = CGP::voronoi_areas(mesh()).cwiseInverse();
    const CGP::Points& f = mesh().positions();
    const CGP::Points curvature = weighted(inverse, laplacian(mesh(), w, f));
    set_positions(f - time_step() / 2 * weighted(inverse, laplacian(mesh(), w, curvature)));
    return true;
  }
};

}  // namespace cgp_benchmark
