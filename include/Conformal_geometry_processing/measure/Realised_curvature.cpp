// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/Realised_curvature.h>

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// what integrals around vertices need of a surface
struct Vertex_integrals {
  Vertex_integrals(const Mesh_view& mesh, const Points& f)
      : areas(Eigen::VectorXd::Zero(mesh.size_of_vertices())), curvatures(areas)
  {
    for (int k = 0; k < mesh.size_of_faces(); ++k)
      for (const int v : mesh.corners(k)) areas[v] += mesh.double_area_vector(k, f).norm() / 6;
    const Enclosure_gradient gradient(mesh, f);
    for (Eigen::Index i = 0; i < f.cols(); ++i)
      curvatures[i] = gradient.of_area.col(i).dot(gradient.of_volume.col(i).normalized()) / 2;
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
Eigen::VectorXd judged_areas(const Surface_ref& surface, const Surface_part& part,
                             const Eigen::VectorXd& before, const Eigen::VectorXd& after)
{
  const int own = part.own_vertices(before.size());
  const Eigen::Vector3d sums =
      part.sum(Eigen::Vector3d(before.head(own).sum(), after.head(own).sum(), own));
  const double least = 1e-9 * sums[0] / sums[2];  // rounding dominates what is smaller
  const double least_ratio = 1e-8 * sums[1] / sums[0];
  const std::vector<char> is_at_rim = boundary_vertices(surface);
  Eigen::VectorXd areas = before;
  for (Eigen::Index v = 0; v < areas.size(); ++v)
    if (is_at_rim[static_cast<std::size_t>(v)] || !(before[v] > least) ||
        !(after[v] > least_ratio * before[v]))
      areas[v] = 0;
  return areas;
}

/// the numbers of two smoothed functions on the own vertices
Realised_curvature compared(const Eigen::VectorXd& realised, const Eigen::VectorXd& asked,
                            const Eigen::VectorXd& areas, const Surface_part& part)
{
  const auto square = [&](const Eigen::VectorXd& v) { return areas.dot(v.cwiseAbs2()); };
  const Eigen::VectorXd judged = (areas.array() > 0).select(asked, 0.);
  const double largest = part.largest(judged.cwiseAbs());
  double large = 0, wrong = 0;
  for (Eigen::Index v = 0; v < areas.size(); ++v) {
    if (std::abs(asked[v]) <= largest / 4) continue;
    large += areas[v];
    if (!(realised[v] * asked[v] > 0)) wrong += areas[v];
  }
  Eigen::VectorXd sums(6);
  sums << square(asked), square(realised), square(realised - asked),
      areas.dot(realised.cwiseProduct(asked)), wrong, large;
  sums = part.sum(sums);
  const double wanted = std::sqrt(sums[0]), found = std::sqrt(sums[1]);
  Realised_curvature result;
  result.share = found / wanted;
  result.correlation = found > 0 ? sums[3] / (found * wanted) : 0;
  result.distance = std::sqrt(sums[2]) / wanted;
  result.wrong_sign = sums[4] / sums[5];
  return result;
}

void check_smoothing(const char* step, Solver_status status)
{
  if (status != Solver_status::success)
    throw Solver_error("realised_curvature",
                       std::string(step) + " of the smoothing matrix failed: " + to_string(status));
}

/// the integrals of the realised change and of rho around each vertex, |V| x 2
Block<double> integrals(const Vertex_integrals& before, const Vertex_integrals& after,
                        const Eigen::VectorXd& areas, const Eigen::VectorXd& rho)
{
  Block<double> b(areas.size(), 2);
  for (Eigen::Index v = 0; v < areas.size(); ++v) {
    const bool is_judged = areas[v] > 0;
    const double spread = is_judged ? std::sqrt(before.areas[v] / after.areas[v]) : 0;
    b(v, 0) = is_judged ? after.curvatures[v] * spread - before.curvatures[v] : 0;
    b(v, 1) = areas[v] * rho[v];
  }
  return b;
}

std::optional<Realised_curvature> realised_curvature(const Mesh_view& mesh, const Points& positions,
                                                     const Eigen::VectorXd& rho,
                                                     bool constants_have_effect,
                                                     const Surface_ref& surface,
                                                     const Smooth& smoothed,
                                                     const Surface_part& part)
{
  const int own = part.own_vertices(positions.cols());
  const Vertex_integrals before(mesh, mesh.positions()), after(mesh, positions);
  const Eigen::VectorXd areas = judged_areas(surface, part, before.areas, after.areas).head(own);
  Block<double> b = integrals(before, after, areas, rho);
  Eigen::VectorXd sums(6);
  sums << areas.sum(), b.col(0).sum(), b.col(1).sum(), b.col(1).cwiseAbs().sum(),
      before.areas.head(own).sum(), own;
  sums = part.sum(sums);
  const double area = sums[0], whole = sums[4];
  if (!(area > 0)) return std::nullopt;
  if (!constants_have_effect)
    for (int k = 0; k < 2; ++k) b.col(k) -= sums[1 + k] / area * areas;
  const double rounding = 1e-10;
  if (!(part.sum(b.col(1).cwiseAbs().sum()) > rounding * sums[3])) return std::nullopt;

  const double l = Realised_curvature::smoothing_length;
  const double l_squared = l * l * whole / (4 * 3.14159265358979323846);
  // Unjudged vertices interpolate; their small masses are for parts where no vertex is judged.
  const Eigen::VectorXd masses = areas.cwiseMax(1e-9 * whole / sums[5]) / l_squared;
  b /= l_squared;
  const Block<double> smooth = smoothed(b, masses);

  Realised_curvature result = compared(smooth.col(0), smooth.col(1), areas, part);
  Eigen::Vector2d norms(0, areas.dot(smooth.col(1).cwiseAbs2()));
  for (Eigen::Index v = 0; v < areas.size(); ++v)
    if (areas[v] > 0) norms[0] += l_squared * l_squared * b(v, 1) * b(v, 1) / areas[v];
  norms = part.sum(norms);
  result.seen_share = std::sqrt(norms[1] / norms[0]);
  result.judged_share = area / whole;
  return result;
}

std::optional<Realised_curvature> realised_curvature(const Mesh_view& mesh, const Points& positions,
                                                     const Eigen::VectorXd& rho,
                                                     bool constants_have_effect,
                                                     const Surface_ref& surface,
                                                     std::shared_ptr<const Sparse_pattern> pattern,
                                                     Solver_ref<double>& solver)
{
  if (!positions.allFinite()) return std::nullopt;
  const auto smooth = [&](const Block<double>& b, const Eigen::VectorXd& masses) {
    Hermitian_sparse_matrix<double> L(pattern);
    assemble_cotan_laplacian(surface, cotan_weights(surface), L);
    check_smoothing("factorization", solver.factorize(L, masses));
    Block<double> x;
    check_smoothing("solution", solver.solve(b, x));
    return x;
  };
  return realised_curvature(mesh, positions, rho, constants_have_effect, surface, smooth);
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
