// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief u_f = 1/2 sum_i |v_i|^2 over an orthonormal basis of the harmonic fields: the canonical
/// metric is u times that of the surface; one number in 1/area for each sheet, which are the faces
/// of a mesh [CGP 4.5.3, 6.4.5.2].
///
/// u is a density of area, not the logarithm of a scale. Its integral is the genus. u depends only
/// on the conformal structure: conformally equivalent surfaces have the same u dA, and every
/// orthonormal basis gives the same u. Costs O(G |F|).
///
/// \param surface closed
/// \param one_forms an orthonormal basis of the harmonic forms, |E| x 2G
/// \param function named in the exception
/// \throw Precondition_error on a sphere, which has no harmonic forms
Eigen::VectorXd canonical_area_density(const Surface_ref& surface, const Eigen::MatrixXd& one_forms,
                                       const std::string& function = "canonical_area_density");

/// \ingroup PkgFlow
/// \brief the area of each vertex in the canonical metric, a third of the faces around it: |V|
/// numbers that sum up to the genus. The target of `Moebius_balancing`.
///
/// Computed once for a flow, because conformal deformations do not change it.
/// \param density `canonical_area_density()`
Eigen::VectorXd canonical_vertex_areas(const Surface_ref& surface, const Eigen::VectorXd& density);

}  // namespace Conformal_geometry_processing
