// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <cmath>
#include <functional>

#include "support/tori.h"

/// The torus around the z axis with radii 2 and 1 in closed form: angles u around the axis, v
/// around the tube, the frame E_u, E_v, N with E_u x E_v = N, and the metric w^2 du^2 + dv^2, w = 2
/// + cos v.
namespace cgp_test {

/// of (u, v), with derivatives by differences
struct Function {
  std::function<double(double, double)> f;

  double operator()(double u, double v) const { return f(u, v); }
  Function du() const
  {
    return {[f = f](double u, double v) { return (f(u + step, v) - f(u - step, v)) / (2 * step); }};
  }
  Function dv() const
  {
    return {[f = f](double u, double v) { return (f(u, v + step) - f(u, v - step)) / (2 * step); }};
  }

  static constexpr double step = 1e-4;
};

inline double width(double v)
{
  return 2 + std::cos(v);
}

inline Eigen::Matrix3d frame(double u, double v)
{
  Eigen::Matrix3d F;
  F.col(0) << -std::sin(u), std::cos(u), 0;
  F.col(1) << -std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v);
  F.col(2) << std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v);
  return F;
}

/// the tangent field a E_u + b E_v
struct Field {
  Function a, b;

  Eigen::Vector3d operator()(double u, double v) const
  {
    return frame(u, v) * Eigen::Vector3d(a(u, v), b(u, v), 0);
  }
};

inline Field gradient_of(const Function& phi)
{
  return {{[d = phi.du()](double u, double v) { return d(u, v) / width(v); }}, phi.dv()};
}

inline Function divergence_of(const Field& X)
{
  return {[X](double u, double v) {
    return (X.a.du()(u, v) - X.b(u, v) * std::sin(v)) / width(v) + X.b.dv()(u, v);
  }};
}

inline Function curl_of(const Field& X)
{
  return {[X](double u, double v) {
    return (X.b.du()(u, v) + X.a(u, v) * std::sin(v)) / width(v) - X.a.dv()(u, v);
  }};
}

inline Field shape_operator_of(const Field& X)
{
  return {{[X](double u, double v) { return X.a(u, v) * std::cos(v) / width(v); }}, X.b};
}

/// a mesh of 2n x n squares, and functions of it sampled there
class Torus_sample {
 public:
  explicit Torus_sample(int n) : m_n(n), m_mesh(torus(2, 1, 2 * n, n)) {}

  const Mesh_view& mesh() const { return m_mesh; }
  double h() const { return 1. / m_n; }

  Eigen::VectorXd at_vertices(const Function& f) const { return numbers(f, 2 * m_n * m_n, false); }
  Eigen::VectorXd on_faces(const Function& f) const { return numbers(f, 4 * m_n * m_n, true); }

  template <class Vectors>
  Points at_vertices(const Vectors& X) const
  {
    return vectors(X, 2 * m_n * m_n, false);
  }
  template <class Vectors>
  Points on_faces(const Vectors& X) const
  {
    return vectors(X, 4 * m_n * m_n, true);
  }
  Points normals() const
  {
    return at_vertices([](double u, double v) { return Eigen::Vector3d(frame(u, v).col(2)); });
  }

  /// relative, in L2; of numbers or of vectors in columns, at vertices or on faces
  template <class Values>
  double error(const Values& found, const Values& expected) const
  {
    const Eigen::Index count = found.cols() == 1 ? found.rows() : found.cols();
    const Eigen::VectorXd w = count == m_mesh.size_of_faces()
                                  ? Conformal_geometry_processing::face_areas(m_mesh)
                                  : Conformal_geometry_processing::vertex_areas(m_mesh);
    const auto norm = [&](const Values& x) {
      double sum = 0;
      for (Eigen::Index i = 0; i < count; ++i)
        sum += w[i] * (x.cols() == 1 ? x(i, 0) * x(i, 0) : x.col(i).squaredNorm());
      return std::sqrt(sum);
    };
    return norm(found - expected) / norm(expected);
  }

 private:
  /// the angles of a vertex, or of the centroid of a face
  Eigen::Vector2d angles(int index, bool of_face) const
  {
    const int vertex = of_face ? index / 2 : index;
    double i = vertex / m_n, j = vertex % m_n;
    if (of_face) i += index % 2 == 0 ? 2 / 3. : 1 / 3., j += index % 2 == 0 ? 1 / 3. : 2 / 3.;
    return {pi * i / m_n, 2 * pi * j / m_n};
  }

  Eigen::VectorXd numbers(const Function& f, int count, bool of_faces) const
  {
    Eigen::VectorXd x(count);
    for (int k = 0; k < count; ++k) x[k] = f(angles(k, of_faces)[0], angles(k, of_faces)[1]);
    return x;
  }

  template <class Vectors>
  Points vectors(const Vectors& X, int count, bool of_faces) const
  {
    Points x(3, count);
    for (int k = 0; k < count; ++k) x.col(k) = X(angles(k, of_faces)[0], angles(k, of_faces)[1]);
    return x;
  }

  int m_n;
  Mesh_view m_mesh;
};

}  // namespace cgp_test
