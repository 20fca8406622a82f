// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/dirac_energy.h>

#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace Conformal_geometry_processing {

void assemble_dirac_energy(const Surface_ref& surface, const Curvature_potential& rho,
                           Hermitian_sparse_matrix<Quaternion<double>>& X)
{
  internal::assemble_sheets(surface, X, [&](const Sheet& sheet, const internal::Index_range& own) {
    const Eigen::Vector3d r = rho.at_corners(sheet);
    const Eigen::Matrix3d& e = sheet.vectors;
    const double scale = 1 / (4 * sheet.area), mass = sheet.area / 9;
    const Eigen::Vector3d n =
        scale * e.col(0).cross(e.col(1));  // the same for e_1, e_2 and e_2, e_0
    const auto entry = [&](int i, int j) {
      Quaternion<double> x;
      if (i != j) x = imaginary((r[i] * e.col(j) - r[j] * e.col(i)) / 6 - n);
      x.w = scale * e.col(i).dot(e.col(j)) + mass * r[i] * r[j];
      return x * sheet.share;
    };
    internal::add_sheet(sheet, own, entry, X);
  });
}

Hermitian_sparse_matrix<Quaternion<double>> dirac_energy(const Surface_ref& surface,
                                                         const Curvature_potential& rho)
{
  Hermitian_sparse_matrix<Quaternion<double>> X(vertex_graph(surface));
  assemble_dirac_energy(surface, rho, X);
  return X;
}

Hermitian_sparse_matrix<Quaternion<double>> dirac_form(const Surface_ref& surface,
                                                       const Curvature_potential& rho)
{
  Hermitian_sparse_matrix<Quaternion<double>> K(vertex_graph(surface));
  internal::assemble_sheets(surface, K, [&](const Sheet& sheet, const internal::Index_range& own) {
    const Eigen::Vector3d r = rho.at_corners(sheet);
    const auto entry = [&](int i, int j) {
      const Eigen::Vector3d e = (sheet.vectors.col(i) - sheet.vectors.col(j)) / 12;
      Quaternion<double> k = imaginary(e);
      k.w = -sheet.area * (r[i] + r[j]) / 18;
      return k * sheet.share;
    };
    internal::add_sheet(sheet, own, entry, K);
  });
  return K;
}

internal::Dirac_forms dirac_forms(const Surface_ref& surface, const Curvature_potential& rho,
                                  const Block<Quaternion<double>>& vectors)
{
  const Eigen::Index k = vectors.cols();
  internal::Dirac_forms forms{Block<Quaternion<double>>(k, k), Block<Quaternion<double>>(k, k)};
  Block<Quaternion<double>> half(k, k);
  Quaternion_vector<double> average(k), image(k);  // of B, and of M (D - R), on one sheet
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    const Eigen::Vector3d r = rho.at_corners(sheet);
    average.setConstant({});
    image.setConstant({});
    for (int c = 0; c < 3; ++c) {
      const Quaternion<double> row = internal::dirac_row(sheet, r, c);
      const int v = sheet.corners[static_cast<std::size_t>(c)];
      for (Eigen::Index a = 0; a < k; ++a) {
        average[a] += vectors(v, a) / 3.;
        image[a] += row * vectors(v, a);
      }
    }
    for (Eigen::Index a = 0; a < k; ++a)
      for (Eigen::Index b = 0; b < k; ++b) {
        half(a, b) += sheet.share / 2 * (conjugate(average[a]) * image[b]);
        forms.mass(a, b) += sheet.share * sheet.area * (conjugate(average[a]) * average[b]);
      }
  }
  for (Eigen::Index a = 0; a < k; ++a)
    for (Eigen::Index b = 0; b < k; ++b) forms.dirac(a, b) = half(a, b) + conjugate(half(b, a));
  return forms;
}

Quaternion_vector<double> apply_dirac_form(const Surface_ref& surface,
                                           const Curvature_potential& rho,
                                           const Quaternion_vector<double>& lambda)
{
  Quaternion_vector<double> result = Quaternion_vector<double>::Constant(lambda.size(), {});
  internal::for_each_owned_range(surface.size_of_vertices(), [&](const internal::Index_range& own) {
    internal::for_each_sheet_at(own, surface, [&](const Sheet& sheet) {
      const Eigen::Vector3d r = rho.at_corners(sheet);
      Quaternion<double> average, image;  // as above
      std::array<Quaternion<double>, 3> row;
      for (std::size_t c = 0; c < 3; ++c) {
        row[c] = internal::dirac_row(sheet, r, static_cast<int>(c));
        average += lambda[sheet.corners[c]] / 3.;
        image += row[c] * lambda[sheet.corners[c]];
      }
      for (std::size_t c = 0; c < 3; ++c)
        if (own.contains(sheet.corners[c]))
          result[sheet.corners[c]] += sheet.share * (image / 6. + conjugate(row[c]) * average / 2.);
    });
  });
  return result;
}

namespace internal {

/// Re <B lambda, M_F D lambda>, Re <B lambda, M_F R lambda> and <B lambda, M_F B lambda>
struct Quotient_terms {
  double dirac = 0, potential = 0, mass = 0;

  Quotient_terms& operator+=(const Quotient_terms& other)
  {
    dirac += other.dirac;
    potential += other.potential;
    mass += other.mass;
    return *this;
  }
};

Quotient_terms quotient_terms(const Surface_ref& surface, const Curvature_potential& rho,
                              const Quaternion_vector<double>& lambda)
{
  return sum_over_sheets(surface, Quotient_terms(), [&](const Sheet& sheet, Quotient_terms& sum) {
    const Eigen::Vector3d r = rho.at_corners(sheet);
    Quaternion<double> average, dirac, potential;  // 3 B lambda, M D lambda and 3 R lambda there
    for (int c = 0; c < 3; ++c) {
      const Quaternion<double>& l = lambda[sheet.corners[static_cast<std::size_t>(c)]];
      average += l;
      dirac += dirac_row(sheet, Eigen::Vector3d::Zero(), c) * l;
      potential += r[c] * l;
    }
    sum.dirac += sheet.share / 3 * dot(average, dirac);
    sum.potential += sheet.share * sheet.area / 9 * dot(average, potential);
    sum.mass += sheet.share * sheet.area / 9 * squared_norm(average);
  });
}

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

}  // namespace internal

double dirac_quotient(const Surface_ref& surface, const Curvature_potential& rho,
                      const Quaternion_vector<double>& lambda)
{
  const auto terms = internal::quotient_terms(surface, rho, lambda);
  return (terms.dirac - terms.potential) / terms.mass;
}

double potential_quotient(const Surface_ref& surface, const Curvature_potential& rho,
                          const Quaternion_vector<double>& lambda)
{
  const auto terms = internal::quotient_terms(surface, rho, lambda);
  return terms.potential / terms.mass;
}

double dirac_misfit(const Surface_ref& surface, const Curvature_potential& rho,
                    const Quaternion_vector<double>& lambda, const internal::Surface_part& part)
{
  using Terms = Eigen::Array2d;  // energy and mass
  const Terms own = internal::sum_over_sheets(
      surface, Terms(Terms::Zero()),
      [&](const Sheet& sheet, Terms& terms) {
        const Eigen::Vector3d r = rho.at_corners(sheet);
        Quaternion<double> image;
        for (int c = 0; c < 3; ++c) {
          const auto& l = lambda[sheet.corners[static_cast<std::size_t>(c)]];
          image += internal::dirac_row(sheet, r, c) * l;
          terms[1] += sheet.share * sheet.area / 3 * squared_norm(l);
        }
        terms[0] += sheet.share * squared_norm(image) / sheet.area;
      },
      part);
  const Eigen::VectorXd sum = part.sum(own.matrix());
  return std::sqrt(sum[0] / sum[1]);
}

}  // namespace Conformal_geometry_processing
