// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/potential_derivative.h>

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/sheet_loops.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace Conformal_geometry_processing::internal {

/// the rows of M (D - R) on a sheet, divided by its share
std::array<Quaternion<double>, 3> dirac_rows(const Sheet& sheet, const Curvature_potential& rho)
{
  const Eigen::Vector3d r = rho.at_corners(sheet);
  return {dirac_row(sheet, r, 0), dirac_row(sheet, r, 1), dirac_row(sheet, r, 2)};
}

/// Calls `add(sheet, own)` on several threads, with ranges of the values of rho and all sheets that
/// have one of these
template <class Add>
void for_each_sheet_of_potential(const Surface_ref& surface, Curvature_potential::On on,
                                 Eigen::Index values, const Add& add)
{
  const bool is_on_vertices = on == Curvature_potential::On::vertices;
  for_each_owned_range(static_cast<int>(values), [&](const Index_range& own) {
    const auto concerns = [&](const Sheet& sheet) {
      return is_on_vertices ? own.touches(sheet) : own.contains(sheet.face);
    };
    for_each_sheet_if(surface, concerns, [&](const Sheet& sheet) { add(sheet, own); });
  });
}

Block<Quaternion<double>> energy_change(const Surface_ref& surface, const Curvature_potential& rho,
                                        const Quaternion_vector<double>& lambda,
                                        const Eigen::MatrixXd& changes)
{
  Block<Quaternion<double>> result =
      Block<Quaternion<double>>::Constant(lambda.size(), changes.cols(), {});
  const auto add = [&](const Sheet& sheet, const Index_range& own) {
    const std::array<Quaternion<double>, 3> row = dirac_rows(sheet, rho);
    Quaternion<double> image;
    for (std::size_t c = 0; c < 3; ++c) image += row[c] * lambda[sheet.corners[c]];
    for (Eigen::Index k = 0; k < changes.cols(); ++k) {
      std::array<double, 3> d;
      Quaternion<double> change;  // E lambda
      for (std::size_t c = 0; c < 3; ++c) {
        d[c] = changes(potential_index(sheet, rho.on, c), k) / 3;
        change += d[c] * lambda[sheet.corners[c]];
      }
      for (std::size_t c = 0; c < 3; ++c)
        if (own.contains(sheet.corners[c]))
          result(sheet.corners[c], k) += sheet.share * (d[c] * image + conjugate(row[c]) * change);
    }
  };
  for_each_owned_range(surface.size_of_vertices(), [&](const Index_range& own) {
    for_each_sheet_at(own, surface, [&](const Sheet& sheet) { add(sheet, own); });
  });
  return result;
}

Eigen::MatrixXd energy_gradient(const Surface_ref& surface, const Curvature_potential& rho,
                                const Quaternion_vector<double>& lambda,
                                const Block<Quaternion<double>>& z)
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rho.values.size(), z.cols());
  const auto add = [&](const Sheet& sheet, const Index_range& own) {
    const std::array<Quaternion<double>, 3> row = dirac_rows(sheet, rho);
    Quaternion<double> image;
    for (std::size_t c = 0; c < 3; ++c) image += row[c] * lambda[sheet.corners[c]];
    for (Eigen::Index k = 0; k < z.cols(); ++k) {
      Quaternion<double> other;  // M A z
      for (std::size_t c = 0; c < 3; ++c) other += row[c] * z(sheet.corners[c], k);
      for (std::size_t c = 0; c < 3; ++c) {
        const int i = potential_index(sheet, rho.on, c);
        const Quaternion<double> product =
            conjugate(z(sheet.corners[c], k)) * image + conjugate(lambda[sheet.corners[c]]) * other;
        if (own.contains(i)) result(i, k) += sheet.share / 3 * product.w;
      }
    }
  };
  for_each_sheet_of_potential(surface, rho.on, rho.values.size(), add);
  return result;
}

Eigen::VectorXd form_gradient(const Surface_ref& surface, Curvature_potential::On on,
                              const Quaternion_vector<double>& lambda)
{
  const bool is_on_vertices = on == Curvature_potential::On::vertices;
  Eigen::VectorXd result =
      Eigen::VectorXd::Zero(is_on_vertices ? surface.size_of_vertices() : surface.size_of_faces());
  const auto add = [&](const Sheet& sheet, const Index_range& own) {
    Quaternion<double> average;
    for (const int v : sheet.corners) average += lambda[v] / 3.;
    for (std::size_t c = 0; c < 3; ++c)
      if (const int i = potential_index(sheet, on, c); own.contains(i))
        result[i] +=
            sheet.share * sheet.area / 3 * (conjugate(average) * lambda[sheet.corners[c]]).w;
  };
  for_each_sheet_of_potential(surface, on, result.size(), add);
  return result;
}

}  // namespace Conformal_geometry_processing::internal
