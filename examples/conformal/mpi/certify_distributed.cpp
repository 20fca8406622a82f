// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "certify_distributed.h"

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/certify.h>

#include <cmath>

namespace conformal::mpi {
namespace {

/// the least value that a share of the weight is at or below, by bisection
double quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, double share)
{
  double low = smallest(values.minCoeff()), high = largest(values.maxCoeff());
  const double wanted = share * sum(weights.sum());
  for (int i = 0; i < 50 && std::isfinite(high); ++i) {
    const double middle = low + (high - low) / 2;
    const double below = sum((values.array() <= middle).select(weights, 0).sum());
    (below >= wanted ? high : low) = middle;
  }
  return high;
}

CGP::internal::Area_distortion scales_of(const Eigen::VectorXd& areas, const Eigen::VectorXd& now)
{
  CGP::internal::Area_distortion d;
  const Eigen::VectorXd scale = now.cwiseQuotient(areas).cwiseSqrt(), u = scale.array().log();
  const double before = sum(areas.sum()), after = sum(now.sum());
  const double mean = sum(areas.dot(u)) / before, usual = std::log(after / before) / 2;
  d.min_scale = smallest(scale.minCoeff());
  d.max_scale = largest(scale.maxCoeff());
  d.log_deviation = std::sqrt(sum(areas.dot((u.array() - mean).square().matrix())) / before);
  const double ten = std::log(10.);
  const double shrunk = sum(((u.array() - usual) < -ten).select(areas, 0).sum()) / before;
  const double grown = sum(((u.array() - usual) > ten).select(now, 0).sum()) / after;
  d.collapsed_share = (std::max)(shrunk, grown);
  const Eigen::VectorXd octaves = (u.array() - usual) / std::log(2.);
  d.histogram = sum_of(Eigen::VectorXd(areas.sum() *
                                       CGP::histogram(octaves, areas, 16, -d.octaves, d.octaves))) /
                before;
  return d;
}

CGP::internal::Length_cross_ratio_change cross_ratios(const Distributed_mesh& mesh,
                                                      const CGP::Points& f)
{
  const Eigen::VectorXd change = CGP::log_length_cross_ratios(mesh.mesh(), f) -
                                 CGP::log_length_cross_ratios(mesh.mesh(), mesh.mesh().positions());
  double squares = 0, most = 0, count = 0;
  for (int k = 0; k < mesh.mesh().size_of_edges(); ++k)
    if (mesh.counts(k)) {
      squares += change[k] * change[k];
      most = (std::max)(most, std::abs(change[k]));
      ++count;
    }
  return {std::sqrt(sum(squares) / sum(count)), largest(most)};
}

int flips(const Distributed_mesh& mesh, const CGP::Points& f,
          const CGP::Quaternion_vector<double>& lambda)
{
  const CGP::Points expected = CGP::rotated_normals(mesh.mesh(), lambda);
  double count = 0;
  for (int i = 0; i < mesh.own_faces(); ++i)
    count += !(mesh.mesh().double_area_vector(i, f).dot(expected.col(i)) > 0);
  return static_cast<int>(sum(count));
}

Eigen::VectorXd at_own_vertices(const Distributed_mesh& mesh, const CGP::internal::Face_maps& maps)
{
  Eigen::VectorXd total = Eigen::VectorXd::Zero(mesh.mesh().size_of_vertices()), weight = total;
  for (int i = 0; i < mesh.mesh().size_of_faces(); ++i)
    for (const int v : mesh.mesh().corners(i)) {
      total[v] += maps.areas[i] * (std::min)(maps.quasi_conformal[i], 1e30);
      weight[v] += maps.areas[i];
    }
  return total.cwiseQuotient(weight).head(mesh.own_vertices());
}

}  // namespace

double closure_residual(const Distributed_mesh& mesh, const Eigen::VectorXd& weights,
                        const CGP::Points& f, const Eigen::MatrixX3d& edges)
{
  double open = 0, all = 0;
  for (int k = 0; k < mesh.mesh().size_of_edges(); ++k)
    if (mesh.counts(k)) {
      const auto [i, j] = mesh.mesh().ends(k);
      const Eigen::Vector3d e = edges.row(k);
      open += std::abs(weights[k]) * (f.col(j) - f.col(i) - e).squaredNorm();
      all += std::abs(weights[k]) * e.squaredNorm();
    }
  return std::sqrt(sum(open) / sum(all));
}

void restore_area(const Distributed_mesh& mesh, CGP::Points& f,
                  CGP::Quaternion_vector<double>& lambda)
{
  Eigen::Matrix<double, 8, 1> sums = Eigen::Matrix<double, 8, 1>::Zero();
  const auto add = [&](const CGP::Points& p, int face, Eigen::Index at) {
    const double area = mesh.mesh().double_area_vector(face, p).norm() / 2;
    sums[at] += area;
    for (const int v : mesh.mesh().corners(face)) sums.segment<3>(at + 1) += area / 3 * p.col(v);
  };
  for (int i = 0; i < mesh.own_faces(); ++i) {
    add(mesh.mesh().positions(), i, 0);
    add(f, i, 4);
  }
  sums = sum_of(sums);
  const double scale = std::sqrt(sums[0] / sums[4]);
  f *= scale;
  CGP::components(lambda) *= std::sqrt(scale);
  f.colwise() += sums.segment<3>(1) / sums[0] - scale * sums.segment<3>(5) / sums[4];
}

Eigen::VectorXd certify(const Distributed_mesh& mesh, const CGP::Points& f,
                        const CGP::Quaternion_vector<double>& lambda, CGP::Spin_report& report)
{
  const CGP::internal::Face_maps maps(mesh.mesh(), f);
  const Eigen::VectorXd Q = maps.quasi_conformal.head(mesh.own_faces()),
                        areas = maps.areas.head(mesh.own_faces()),
                        now = maps.new_areas.head(mesh.own_faces());
  CGP::Conformality& map = report.conformality;
  map.quasi_conformal = {sum(areas.dot(Q)) / sum(areas.sum()), quantile(Q, areas, .99),
                         largest(Q.maxCoeff())};
  map.quasi_conformal_of_new_area = sum(now.dot(Q)) / sum(now.sum());
  map.length_cross_ratio = cross_ratios(mesh, f);
  map.scale = scales_of(areas, now);
  map.flipped_faces = flips(mesh, f, lambda);
  map.flipped_share = map.flipped_faces / sum(static_cast<double>(mesh.own_faces()));
  const Eigen::VectorXd size = CGP::components(lambda).colwise().norm();
  report.min_spin_ratio = smallest(size.minCoeff()) / largest(size.maxCoeff());
  report.converged = report.converged && smallest(f.allFinite() ? 1 : 0) > 0;
  return at_own_vertices(mesh, maps);
}

}  // namespace conformal::mpi
