// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_mesh.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

/// What `CGP::internal::certify()` and others measure, of a surface in parts. Collective.
namespace conformal::mpi {

/// likewise `CGP::internal::closure_residual()`
double closure_residual(const Distributed_mesh& mesh, const Eigen::VectorXd& weights,
                        const CGP::Points& f, const Eigen::MatrixX3d& edges);

/// likewise `CGP::restore_area()`
void restore_area(const Distributed_mesh& mesh, CGP::Points& f,
                  CGP::Quaternion_vector<double>& lambda);

/// \brief how conformal the map to new positions is, and the ratio of the smallest to the largest
/// spin.
/// \return the quasi-conformal error at the own vertices, the mean of the faces around
Eigen::VectorXd certify(const Distributed_mesh& mesh, const CGP::Points& f,
                        const CGP::Quaternion_vector<double>& lambda, CGP::Spin_report& report);

}  // namespace conformal::mpi
