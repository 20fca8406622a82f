// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace cgp_benchmark {

/// spin transformations of spheres, disks and tori on finer and finer meshes
void measure_convergence_in_space();

/// steps of the flow on a surface with three handles and on an annulus
void measure_convergence_in_time();

/// edits of tori on finer and finer meshes, and the conformal class of a torus in the flow
void measure_handles();

}  // namespace cgp_benchmark
