// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// \brief four points in a circle x_0 x_1 x_2 x_3: the two triangles at the edge x_0 x_2, and the
/// angle beta between their circumcircles.
///
/// With edges A = x_1 - x_0, B, C, D around the circle, cos beta = N / |A||B||C||D|, where
/// N = <A,C><B,D> - <A,B><C,D> - <B,C><D,A>; it is minus the real part of the cross-ratio by its
/// norm.
struct Circle_angle {
  std::array<Eigen::Vector3d, 4> edges;
  double angle, cosine, lengths;  // lengths: the product of all four

  explicit Circle_angle(const std::array<Eigen::Vector3d, 4>& x)
  {
    for (std::size_t i = 0; i < 4; ++i) edges[i] = x[(i + 1) % 4] - x[i];
    const auto& [A, B, C, D] = edges;
    lengths = A.norm() * B.norm() * C.norm() * D.norm();
    const double N = A.dot(C) * B.dot(D) - A.dot(B) * C.dot(D) - B.dot(C) * D.dot(A);
    const Eigen::Vector3d AB = A.cross(B), CD = C.cross(D);
    // The imaginary part of the product A B C D of quaternions: exact also where beta is small.
    const Eigen::Vector3d imaginary = AB.cross(CD) - A.dot(B) * CD - C.dot(D) * AB;
    cosine = N / lengths;
    angle = std::atan2(imaginary.norm(), N);
  }

  /// the derivative of beta by the four points; zero where beta is zero and has none
  std::array<Eigen::Vector3d, 4> gradient() const
  {
    std::array<Eigen::Vector3d, 4> by_edge, by_point;
    const double sine = std::sin(angle);
    for (std::size_t i = 0; i < 4; ++i) {
      // N is the same for every rotation of the four edges.
      const Eigen::Vector3d &a = edges[i], &b = edges[(i + 1) % 4], &c = edges[(i + 2) % 4],
                            &d = edges[(i + 3) % 4];
      const Eigen::Vector3d dN = b.dot(d) * c - c.dot(d) * b - b.dot(c) * d;
      const double slope = sine > 0 ? -1 / sine : 0;
      by_edge[i] = slope * (dN / lengths - cosine / a.squaredNorm() * a);
    }
    for (std::size_t i = 0; i < 4; ++i) by_point[i] = by_edge[(i + 3) % 4] - by_edge[i];
    return by_point;
  }
};

/// the vertices around the edge k of a closed mesh: beginning, right, end, left
inline std::array<int, 4> circle_of_edge(const CGP::Mesh_view& mesh, int k)
{
  const int h = mesh.halfedges_begin(k)[0], g = mesh.twin(h);
  return {mesh.from(h), mesh.to(CGP::Mesh_view::next_in_face(g)), mesh.to(h),
          mesh.to(CGP::Mesh_view::next_in_face(h))};
}

inline Circle_angle circle_angle(const CGP::Mesh_view& mesh, int k)
{
  std::array<Eigen::Vector3d, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = mesh.position(circle_of_edge(mesh, k)[i]);
  return Circle_angle(x);
}

/// \brief W = sum over the edges of beta, less pi for each vertex [BS05]: not negative, zero if and
/// only if the mesh is convex and inscribed in a sphere, and invariant under Moebius maps.
///
/// A discrete version of the integral of H^2 - K.
inline double circle_angle_energy(const CGP::Mesh_view& mesh)
{
  double sum = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k) sum += circle_angle(mesh, k).angle;
  return sum - std::acos(-1.) * mesh.size_of_vertices();
}

/// its derivative by the positions, 3 x |V|
inline CGP::Points circle_angle_gradient(const CGP::Mesh_view& mesh)
{
  CGP::Points gradient = CGP::Points::Zero(3, mesh.size_of_vertices());
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const auto vertices = circle_of_edge(mesh, k);
    const auto of_edge = circle_angle(mesh, k).gradient();
    for (std::size_t i = 0; i < 4; ++i) gradient.col(vertices[i]) += of_edge[i];
  }
  return gradient;
}

}  // namespace cgp_benchmark
