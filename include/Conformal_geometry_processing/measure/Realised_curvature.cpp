// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/Realised_curvature.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// what integrals around vertices need of a surface
struct Vertex_integrals {
  Vertex_integrals(const Mesh_view& mesh, const Points& f)
      : areas(Eigen::VectorXd::Zero(mesh.size_of_vertices())), curvatures(areas)
  {
    // The gradients of area and volume, which are bounded for thin faces too.
    Points of_area = Points::Zero(3, f.cols()), of_volume = of_area;
    for (int k = 0; k < mesh.size_of_faces(); ++k) {
      const Eigen::Vector3d normal = mesh.double_area_vector(k, f);
      const double size = normal.norm();
      if (!(size > 0)) continue;
      const auto& v = mesh.corners(k);
      for (std::size_t c = 0; c < 3; ++c) {
        const Eigen::Vector3d opposite = f.col(v[(c + 2) % 3]) - f.col(v[(c + 1) % 3]);
        of_area.col(v[c]) += normal.cross(opposite) / (2 * size);
        of_volume.col(v[c]) += normal;
        areas[v[c]] += size / 6;
      }
    }
    for (Eigen::Index i = 0; i < f.cols(); ++i)
      curvatures[i] = of_area.col(i).dot(of_volume.col(i).normalized()) / 2;
  }

  Eigen::VectorXd areas;       // M
  Eigen::VectorXd curvatures;  // h
};

Eigen::VectorXd values_at_vertices(const Mesh_view& mesh, const Curvature_potential& rho)
{
  if (rho.on == Curvature_potential::On::vertices) return rho.values;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.size_of_vertices()), areas = sum;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double area = mesh.double_area_vector(f).norm();
    for (const int v : mesh.corners(f)) sum[v] += area * rho.values[f], areas[v] += area;
  }
  return (areas.array() > 0).select(sum.cwiseQuotient(areas), 0.);
}

/// the areas of the vertices that are judged, zero for the others
Eigen::VectorXd judged_areas(const Surface_ref& surface, const Eigen::VectorXd& before,
                             const Eigen::VectorXd& after)
{
  const double least = 1e-9 * before.mean();  // rounding dominates what is smaller
  const double least_ratio = 1e-8 * after.sum() / before.sum();
  const std::vector<char> is_at_rim = boundary_vertices(surface);
  Eigen::VectorXd areas = before;
  for (Eigen::Index v = 0; v < areas.size(); ++v)
    if (is_at_rim[static_cast<std::size_t>(v)] || !(before[v] > least) ||
        !(after[v] > least_ratio * before[v]))
      areas[v] = 0;
  return areas;
}

/// the numbers of two smoothed functions
Realised_curvature compared(const Eigen::VectorXd& realised, const Eigen::VectorXd& asked,
                            const Eigen::VectorXd& areas)
{
  const auto norm = [&](const Eigen::VectorXd& v) { return std::sqrt(areas.dot(v.cwiseAbs2())); };
  const double wanted = norm(asked), found = norm(realised);
  const double common = areas.dot(realised.cwiseProduct(asked));
  Realised_curvature result;
  result.share = found / wanted;
  result.correlation = found > 0 ? common / (found * wanted) : 0;
  result.distance = norm(realised - asked) / wanted;
  double largest = 0, large = 0, wrong = 0;
  for (Eigen::Index v = 0; v < areas.size(); ++v)
    if (areas[v] > 0) largest = (std::max)(largest, std::abs(asked[v]));
  for (Eigen::Index v = 0; v < areas.size(); ++v) {
    if (std::abs(asked[v]) <= largest / 4) continue;
    large += areas[v];
    if (!(realised[v] * asked[v] > 0)) wrong += areas[v];
  }
  result.wrong_sign = wrong / large;
  return result;
}

void check_smoothing(const char* step, Solver_status status)
{
  if (status != Solver_status::success)
    throw Solver_error("realised_curvature",
                       std::string(step) + " of the smoothing matrix failed: " + to_string(status));
}

std::optional<Realised_curvature> realised_curvature(const Mesh_view& mesh, const Points& positions,
                                                     const Eigen::VectorXd& rho,
                                                     bool constants_have_effect,
                                                     const Surface_ref& surface,
                                                     std::shared_ptr<const Sparse_pattern> pattern,
                                                     Solver_ref<double>& solver)
{
  if (!positions.allFinite()) return std::nullopt;
  const Vertex_integrals before(mesh, mesh.positions()), after(mesh, positions);
  const Eigen::VectorXd areas = judged_areas(surface, before.areas, after.areas);
  const double area = areas.sum();
  if (!(area > 0)) return std::nullopt;
  Block<double> b(areas.size(), 2);
  for (Eigen::Index v = 0; v < areas.size(); ++v) {
    const bool is_judged = areas[v] > 0;
    const double spread = is_judged ? std::sqrt(before.areas[v] / after.areas[v]) : 0;
    b(v, 0) = is_judged ? after.curvatures[v] * spread - before.curvatures[v] : 0;
    b(v, 1) = areas[v] * rho[v];
  }
  const double size = b.col(1).cwiseAbs().sum();
  if (!constants_have_effect)
    for (int k = 0; k < 2; ++k) b.col(k) -= b.col(k).sum() / area * areas;
  const double rounding = 1e-10;
  if (!(b.col(1).cwiseAbs().sum() > rounding * size)) return std::nullopt;

  const double l = Realised_curvature::smoothing_length;
  const double l_squared = l * l * before.areas.sum() / (4 * 3.14159265358979323846);
  Hermitian_sparse_matrix<double> L(std::move(pattern));
  assemble_cotan_laplacian(surface, cotan_weights(surface), L);
  // Unjudged vertices interpolate; their small masses are for parts where no vertex is judged.
  const Eigen::VectorXd masses = areas.cwiseMax(1e-9 * before.areas.mean()) / l_squared;
  check_smoothing("factorization", solver.factorize(L, masses));
  Block<double> smooth;
  b /= l_squared;
  check_smoothing("solution", solver.solve(b, smooth));

  Realised_curvature result = compared(smooth.col(0), smooth.col(1), areas);
  double norm = 0;
  for (Eigen::Index v = 0; v < areas.size(); ++v)
    if (areas[v] > 0) norm += l_squared * l_squared * b(v, 1) * b(v, 1) / areas[v];
  const Eigen::VectorXd seen = smooth.col(1);
  result.seen_share = std::sqrt(areas.dot(seen.cwiseAbs2()) / norm);
  result.judged_share = area / before.areas.sum();
  return result;
}

}  // namespace internal

double Realised_curvature::agreement() const
{
  return (std::min)(share, 1.) * correlation;
}

std::optional<Realised_curvature> realised_curvature(const Mesh_view& mesh, const Points& positions,
                                                     const Curvature_potential& rho,
                                                     bool constants_have_effect,
                                                     const Spin_solvers& solvers)
{
  if (positions.cols() != mesh.size_of_vertices())
    throw Precondition_error("realised_curvature", std::to_string(positions.cols()) +
                                                       " positions, one per vertex is needed: " +
                                                       std::to_string(mesh.size_of_vertices()));
  require_potential(mesh, rho, 1, "realised_curvature");
  const double unit = internal::Normalized_frame(mesh.positions()).unit();
  const Mesh_view own = internal::in_own_frame(mesh);
  const std::shared_ptr<const Sparse_pattern> pattern = vertex_graph(own);
  internal::Solver_ref<double> solver = solvers.solver<double>();
  internal::check_smoothing("analysis", solver.analyze(*pattern));
  if (!positions.allFinite()) return std::nullopt;
  return internal::realised_curvature(
      own, internal::Normalized_frame(positions).to_frame(positions),
      unit * internal::values_at_vertices(own, rho), constants_have_effect, own, pattern, solver);
}

}  // namespace Conformal_geometry_processing
