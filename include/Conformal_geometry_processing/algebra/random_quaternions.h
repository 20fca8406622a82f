// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief Random quaternions, whose components are independent and uniform in [-1/2, 1/2); the same
/// on every platform for the same seed.
///
/// A random vector has a component along every eigenvector, symmetric or not.
Block<Quaternion<double>> random_quaternions(Eigen::Index rows, Eigen::Index columns,
                                             unsigned seed);

}  // namespace Conformal_geometry_processing
