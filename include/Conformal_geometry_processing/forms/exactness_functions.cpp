// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/exactness_functions.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <array>
#include <cstddef>

namespace Conformal_geometry_processing {
namespace internal {

/// the sources c of D^H M D Y = c: half the sum of w omega e over the edges e at each vertex, for
/// each form
Block<Quaternion<double>> adjoint_sources(const Surface_ref& surface, const Harmonic_basis& basis)
{
  const Eigen::VectorXd w = cotan_weights(surface);
  Block<Quaternion<double>> c =
      Block<Quaternion<double>>::Constant(surface.size_of_vertices(), basis.size(), {});
  for (int i = 0; i < basis.size(); ++i)
    for (int k = 0; k < surface.size_of_edges(); ++k) {
      const auto& ends = surface.ends(k);
      const Eigen::Vector3d e = surface.position(ends[1]) - surface.position(ends[0]);
      const Quaternion<double> share = imaginary(w[k] * basis.one_forms(k, i) / 2 * e);
      for (const int v : ends) c(v, i) += share;
    }
  return c;
}

/// the sources of D Z = v in the sense of least squares: D^H M v
Block<Quaternion<double>> field_sources(const Surface_ref& surface, const Harmonic_basis& basis)
{
  Block<Quaternion<double>> c =
      Block<Quaternion<double>>::Constant(surface.size_of_vertices(), basis.size(), {});
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    for (int i = 0; i < basis.size(); ++i) {
      const Eigen::Vector3d v = basis.fields[static_cast<std::size_t>(i)].col(s);
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d e = sheet.share / 2 * sheet.vectors.col(k);
        c(sheet.corners[static_cast<std::size_t>(k)], i) += imaginary(e) * imaginary(v);
      }
    }
  }
  return c;
}

/// one column for each column of sources and each axis of space
Block<Quaternion<double>> sources_along_axes(const Block<Quaternion<double>>& sources)
{
  const std::array<Quaternion<double>, 3> axes = {{{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  Block<Quaternion<double>> c(sources.rows(), 3 * sources.cols());
  for (Eigen::Index i = 0; i < c.cols(); ++i)
    for (Eigen::Index v = 0; v < c.rows(); ++v)
      c(v, i) = sources(v, i / 3) * conjugate(axes[static_cast<std::size_t>(i % 3)]);
  return c;
}

/// \brief z with <a, rho> = sum_i A_i rho_i z_i for all rho, for a function a on the sheets.
/// \param integral integral of a over sheet s divided by its share, in its four components
template <class Integral>
Eigen::MatrixX4d represented(const Surface_ref& surface, Curvature_potential::On on,
                             Integral integral)
{
  const Eigen::VectorXd areas = curvature_areas(surface, on);
  Eigen::MatrixX4d z = Eigen::MatrixX4d::Zero(areas.size(), 4);
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    const Quaternion<double> a = sheet.share * integral(sheet);
    const Eigen::RowVector4d part(a.w, a.x, a.y, a.z);
    if (on == Curvature_potential::On::faces)
      z.row(sheet.face) += part;
    else
      for (const int v : sheet.corners) z.row(v) += part / 3;
  }
  return areas.cwiseInverse().asDiagonal() * z;
}

/// z of the function D y
Eigen::MatrixX4d represented_derivative(const Surface_ref& surface, Curvature_potential::On on,
                                        const Quaternion_vector<double>& y)
{
  return represented(surface, on, [&](const Sheet& sheet) {
    Quaternion<double> image;
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector3d e = sheet.vectors.col(c) / 2;
      image -= imaginary(e) * y[sheet.corners[static_cast<std::size_t>(c)]];
    }
    return image;
  });
}

/// z of the function y itself: its values, or the means of faces
Eigen::MatrixX4d represented_values(const Surface_ref& surface, Curvature_potential::On on,
                                    const Quaternion_vector<double>& y)
{
  if (on == Curvature_potential::On::vertices) return components(y).transpose();
  return represented(surface, on, [&](const Sheet& sheet) {
    const auto& v = sheet.corners;
    return sheet.area / 3 * (y[v[0]] + y[v[1]] + y[v[2]]);
  });
}

}  // namespace internal

Eigen::MatrixXd exactness_functions(const Surface_ref& surface, const Harmonic_basis& basis,
                                    const internal::Spin_response& respond,
                                    Curvature_potential::On on, internal::Coefficients coefficients,
                                    Exactness version)
{
  const bool is_adjoint = version == Exactness::adjoint;
  const bool is_real = coefficients == internal::Coefficients::reals;
  Block<Quaternion<double>> c = is_adjoint ? internal::adjoint_sources(surface, basis)
                                           : internal::field_sources(surface, basis);
  if (is_real) c = internal::sources_along_axes(c);
  const Block<Quaternion<double>> Y = respond(c);
  Eigen::MatrixXd z(curvature_areas(surface, on).size(), 3 * basis.size());
  for (Eigen::Index i = 0; i < Y.cols(); ++i) {
    const Quaternion_vector<double> y = Y.col(i);
    const Eigen::MatrixX4d parts = is_adjoint ? internal::represented_derivative(surface, on, y)
                                              : internal::represented_values(surface, on, y);
    if (is_real)
      z.col(i) = parts.col(0);
    else
      z.middleCols<3>(3 * i) = parts.rightCols<3>();
  }
  return z;
}

}  // namespace Conformal_geometry_processing
