// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "support/minimal_surfaces.h"

/// Prescribed boundary conditions, and errors against known results.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;
using CGP::Boundary_condition;
using CGP::Curvature_potential;
using Complex = std::complex<double>;

Complex complex_of(const Eigen::Vector3d& p);

template <class Function>
Curvature_potential potential_on_vertices(const Mesh_view& mesh, Function rho)
{
  Eigen::VectorXd values(mesh.size_of_vertices());
  for (int v = 0; v < values.size(); ++v) values[v] = rho(mesh.position(v));
  return Curvature_potential::on_vertices(values);
}

/// its values at the centroids of the faces
template <class Function>
Curvature_potential potential_on_faces(const Mesh_view& mesh, Function rho)
{
  Eigen::VectorXd values(mesh.size_of_faces());
  for (int f = 0; f < values.size(); ++f) {
    const auto& v = mesh.corners(f);
    values[f] = rho((mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3);
  }
  return Curvature_potential::on_faces(values);
}

Curvature_potential constant_potential(const Mesh_view& mesh, double c);

/// f(position, frame), a vector, at every boundary vertex
template <class Function>
Points at_boundary(const Mesh_view& mesh, Function f)
{
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(mesh);
  Points values(3, static_cast<Eigen::Index>(b.vertices.size()));
  for (std::size_t k = 0; k < b.vertices.size(); ++k)
    values.col(static_cast<Eigen::Index>(k)) = f(mesh.position(b.vertices[k]), b.frames[k]);
  return values;
}

/// \brief Returns the image of the direction t T + n N + b B at the boundary of a plane mesh under
/// an immersion of the plane, if it is conformal.
/// \param differential with differential(p, v) the derivative at p along v
template <class Differential>
Points image_directions(const Mesh_view& mesh, Differential differential,
                        const Eigen::Vector3d& tnb)
{
  return at_boundary(
      mesh, [&](const Eigen::Vector3d& p, const CGP::internal::Boundary_frame& frame) {
        const Eigen::Vector3d x = differential(p, {1, 0, 0}), y = differential(p, {0, 1, 0});
        const Eigen::Vector3d T = differential(p, frame.col(0)).normalized();
        const Eigen::Vector3d N = x.cross(y).normalized();
        return Eigen::Vector3d(tnb[0] * T + tnb[1] * N + tnb[2] * T.cross(N));
      });
}

Points enneper_directions(const Mesh_view& mesh, const Eigen::Vector3d& tnb);

/// F = z + .3 z^2, which is injective on the unit disk
Eigen::Vector3d quadratic_map(const Eigen::Vector3d& p);

Points quadratic_directions(const Mesh_view& mesh, const Eigen::Vector3d& tnb);

double diagonal(const Points& p);

/// the root of the mean squared distance, by the diagonal of the bounding box of b
double rms_distance(const Points& a, const Points& b);

/// the same up to a similarity
double shape_error(const Points& a, const Points& b);

/// by a single transformation, around holes too: closed forms and tables are those of one
CGP::Spin_result transformed(const Mesh_view& mesh, const Boundary_condition& condition,
                             const Curvature_potential& rho,
                             const CGP::Dirac_options& options = {});

double mean_Q(const CGP::Spin_result& r);

/// Q - 1 of the result agrees with that of a table, to 2 %
void expect_Q(const CGP::Spin_result& r, double Q);

double degrees(double radians);

/// errors at sizes that double fall with this power, to 5 % of a slope of one and 10 % of others
void expect_order(double order, const std::vector<double>& errors);

/// Returns the message with which a transformation, or its condition, is rejected
template <class Call>
std::string refusal_of(Call call)
{
  try {
    call();
  } catch (const CGP::Precondition_error& error) {
    return error.message();
  }
  return "";
}

}  // namespace cgp_test
