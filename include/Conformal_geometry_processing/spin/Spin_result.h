// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// the transformed surface with its report
struct Spin_result {
  Points positions;                  ///< 3 x |V|
  Quaternion_vector<double> lambda;  ///< |V|; df~ = conjugate(lambda) df lambda
  Spin_report report;
};

}  // namespace Conformal_geometry_processing
