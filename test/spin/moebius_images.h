// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "spin/boundary_tools.h"
#include "support/random_delaunay.h"

/// Graphs over plane domains and their images under a Moebius transformation of space: exact data
/// of a spin transformation, with all of rho and the boundary in closed form.
namespace cgp_test {

class Moebius_image {
 public:
  Moebius_image(double h, std::uint64_t seed, std::vector<Circle> holes)
      : m_holes(std::move(holes)),
        m_plane(random_domain(h, seed, m_holes)),
        source(mapped(m_plane, [](const Eigen::Vector3d& p) { return graph(p); })),
        image(mapped(source, [](const Eigen::Vector3d& x) { return inverse(x); }))
  {}

  /// of x -> x / |x|^2 with the factor u = 1 / |x|^2: H~ u = H + <N, grad log u>
  Curvature_potential rho() const
  {
    Eigen::VectorXd rho(m_plane.size_of_vertices());
    for (int v = 0; v < rho.size(); ++v) {
      const Eigen::Vector3d q = source.position(v) - center();
      rho[v] = -2 * q.dot(normal(m_plane.position(v))) / q.squaredNorm();
    }
    return Curvature_potential::on_vertices(rho);
  }

  /// of the image of the smooth surface, in the order of `boundary_frames()`
  Boundary_condition directions(const Eigen::Vector3d& tnb) const
  {
    const std::vector<int> vertices = CGP::boundary_frames(source).vertices;
    Points V(3, static_cast<Eigen::Index>(vertices.size()));
    for (Eigen::Index k = 0; k < V.cols(); ++k) {
      const int v = vertices[static_cast<std::size_t>(k)];
      const Eigen::Vector3d p = m_plane.position(v), N = normal(p),
                            T = differential(p, along_circle(p)).normalized();
      V.col(k) =
          inverse_differential(source.position(v), tnb[0] * T + tnb[1] * N + tnb[2] * T.cross(N));
    }
    return Boundary_condition::directions(tnb, V);
  }

 private:
  static Eigen::Vector3d center() { return {.4, -.3, 1.4}; }

  static Eigen::Vector3d graph(const Eigen::Vector3d& p)
  {
    return {p.x(), p.y(), .25 * std::sin(2 * p.x() + .5) * std::cos(1.5 * p.y())};
  }

  static Eigen::Vector3d differential(const Eigen::Vector3d& p, const Eigen::Vector3d& v)
  {
    const double x = .5 * std::cos(2 * p.x() + .5) * std::cos(1.5 * p.y()),
                 y = -.375 * std::sin(2 * p.x() + .5) * std::sin(1.5 * p.y());
    return {v.x(), v.y(), x * v.x() + y * v.y()};
  }

  static Eigen::Vector3d normal(const Eigen::Vector3d& p)
  {
    return differential(p, {1, 0, 0}).cross(differential(p, {0, 1, 0})).normalized();
  }

  /// reflected, so that it keeps orientation
  static Eigen::Vector3d inverse(const Eigen::Vector3d& x)
  {
    const Eigen::Vector3d q = x - center();
    return Eigen::Vector3d(q.x(), q.y(), -q.z()) / q.squaredNorm();
  }

  static Eigen::Vector3d inverse_differential(const Eigen::Vector3d& x, const Eigen::Vector3d& v)
  {
    const Eigen::Vector3d q = x - center(), w = v - 2 * q.dot(v) / q.squaredNorm() * q;
    return Eigen::Vector3d(w.x(), w.y(), -w.z()) / q.squaredNorm();
  }

  /// with the surface on the left
  Eigen::Vector3d along_circle(const Eigen::Vector3d& p) const
  {
    for (const Circle& c : m_holes) {
      const Eigen::Vector2d r = p.head<2>() - c.center;
      if (r.norm() < c.radius + 1e-9) return {r.y(), -r.x(), 0};
    }
    return {-p.y(), p.x(), 0};
  }

  std::vector<Circle> m_holes;
  Mesh_view m_plane;

 public:
  const Mesh_view source, image;
};

}  // namespace cgp_test
