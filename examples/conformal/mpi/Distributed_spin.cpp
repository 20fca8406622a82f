// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Distributed_spin.h"

#include "Counted_faces.h"
#include "Distributed_matrix.h"
#include "Distributed_solver.h"
#include "Part_solver.h"
#include "free_boundary.h"

#include <Conformal_geometry_processing/measure/Realised_curvature.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Relaxed_surface.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>

#include <algorithm>
#include <utility>

namespace conformal::mpi {
namespace {

using CGP::Quaternion_vector;

/// \brief (L + masses)^-1 b of the own vertices, two columns b at once.
/// \param is_singular whether masses are so small that solutions have constants by rounding alone
Eigen::MatrixXd laplacian_solution(const Distributed_mesh& mesh, const Solution_plan& plan,
                                   const Eigen::VectorXd& masses, const Eigen::MatrixXd& b,
                                   bool is_singular)
{
  CGP::Hermitian_sparse_matrix<double> L = CGP::cotan_laplacian(mesh.mesh());
  const auto diagonal = [&](int v) -> double& {
    return L.value(L.pattern().offsets[static_cast<std::size_t>(v)]);
  };
  for (int v = 0; v < mesh.own_vertices(); ++v) diagonal(v) += masses[v];
  Distributed_matrix<double> matrix(mesh);
  matrix.set(L);
  if (is_singular) matrix.set_kernel_to_constants();
  for (int v = 0; v < mesh.own_vertices(); ++v) diagonal(v) *= 1 + 1e-9;  // pivots stay positive
  const Distributed_solver<double> solver(mesh, plan, matrix.get(), L);
  const Petsc_vec right = matrix.make_vector(), x = matrix.make_vector();
  Eigen::MatrixXd solution(b.rows(), b.cols());
  for (Eigen::Index c = 0; c < b.cols(); c += 2) {  // two columns as a complex one
    const bool is_pair = c + 1 < b.cols();
    with_values(right.get(), [&](PetscScalar* values) {
      for (Eigen::Index v = 0; v < b.rows(); ++v)
        values[v] = PetscScalar(b(v, c), is_pair ? b(v, c + 1) : 0);
    });
    solver.solve(right.get(), x.get());
    with_values(x.get(), [&](const PetscScalar* values) {
      for (Eigen::Index v = 0; v < b.rows(); ++v) {
        solution(v, c) = values[v].real();
        if (is_pair) solution(v, c + 1) = values[v].imag();
      }
    });
  }
  return solution;
}

/// the positions whose edges are nearest to given ones [CGP (5.5)], of the mesh of the part
CGP::Points integrated(const Distributed_mesh& mesh, const Solution_plan& plan,
                       const Eigen::VectorXd& areas, const Eigen::VectorXd& weights,
                       const Eigen::MatrixX3d& edges)
{
  const double shift = 1e-10;  // L is singular, and right-hand sides have no constant part
  const int own = mesh.own_vertices();
  const double area = sum(areas.head(own).sum());
  const Eigen::MatrixX3d b = CGP::codifferential(mesh.mesh(), weights, edges);
  Eigen::MatrixXd f(3, mesh.mesh().size_of_vertices());
  f.leftCols(own) =
      laplacian_solution(mesh, plan, shift / area * areas, b.topRows(own), true).transpose();
  mesh.update(f);
  return f;
}

std::optional<CGP::Realised_curvature> realised_curvature(const Distributed_mesh& mesh,
                                                          const Solution_plan& plan,
                                                          const CGP::Points& f,
                                                          const Eigen::VectorXd& rho)
{
  const auto smooth = [&](const CGP::Block<double>& b,
                          const Eigen::VectorXd& masses) -> CGP::Block<double> {
    return laplacian_solution(mesh, plan, masses, b, false);
  };
  return CGP::internal::realised_curvature(mesh.mesh(), f, rho, !mesh.is_closed(), mesh.mesh(),
                                           smooth, mesh.part());
}

void judge_boundary(const Distributed_mesh& mesh, CGP::Spin_report& report)
{
  report.radius = CGP::internal::radius_of_area(mesh.mesh(), mesh.part());
  report.boundary_fault = CGP::boundary_fault(mesh.mesh(), 0, report, mesh.part());
}

/// the quasi-conformal error at the own vertices, the mean of the faces around
Eigen::VectorXd quality(const Distributed_mesh& mesh, const CGP::Points& f)
{
  const CGP::internal::Face_maps maps(mesh.mesh(), f);
  Eigen::VectorXd total = Eigen::VectorXd::Zero(mesh.mesh().size_of_vertices()), weight = total;
  for (int i = 0; i < mesh.mesh().size_of_faces(); ++i)
    for (const int v : mesh.mesh().corners(i)) {
      total[v] += maps.areas[i] * (std::min)(maps.quasi_conformal[i], 1e30);
      weight[v] += maps.areas[i];
    }
  return total.cwiseQuotient(weight).head(mesh.own_vertices());
}

/// the surface of spins, which are scaled, with what it is judged by
CGP::Spin_result surface_of(const Distributed_mesh& mesh, const Solution_plan& plan,
                            const Eigen::VectorXd& areas, Quaternion_vector<double> lambda,
                            const CGP::Spin_report& report)
{
  CGP::internal::Stopwatch watch;
  CGP::Spin_result result{{}, std::move(lambda), report};
  CGP::Spin_report& r = result.report;
  const Eigen::VectorXd weights = CGP::cotan_weights(mesh.mesh());
  const Eigen::MatrixX3d edges = CGP::transformed_edges(mesh.mesh(), result.lambda);
  result.positions = integrated(mesh, plan, areas, weights, edges);
  r.seconds.reconstruction += watch.lap();
  r.closure_residual =
      CGP::internal::closure_residual(mesh.mesh(), weights, result.positions, edges, mesh.part());
  CGP::restore_area(mesh.mesh(), result.positions, result.lambda, mesh.part());
  CGP::internal::certify(mesh.mesh(), result.positions, result.lambda, r, mesh.part());
  if (!mesh.is_closed()) judge_boundary(mesh, r);
  r.seconds.certificate += watch.lap();
  return result;
}

/// the surface of [CGP (5.3)], whose lengths may change by any factor
CGP::Spin_result unbounded(const Distributed_mesh& mesh, const Solution_plan& plan,
                           const Eigen::VectorXd& areas, const Eigen::VectorXd& rho,
                           const Spin_request& request, const Search_state& start, const Save& save,
                           const Go_further& go_further)
{
  CGP::Spin_report report;
  report.limits = request.limits;
  // the solver of X is not needed any more for positions
  Quaternion_vector<double> lambda =
      mesh.is_closed()
          ? eigenvector(mesh, plan, rho, areas, request.dirac, start, save, go_further, report)
          : spins_with_free_boundary(mesh, plan, rho, areas, report);
  if (report.cancelled) return {{}, std::move(lambda), report};
  report.overlap = overlap(mesh, areas, lambda,
                           Quaternion_vector<double>::Constant(lambda.size(), {1, 0, 0, 0}));
  return surface_of(mesh, plan, areas, std::move(lambda), report);
}

using Search = CGP::internal::Relaxed_surface;

Search_state saved(const Distributed_mesh& mesh, const Search::Position& at)
{
  const CGP::internal::Relaxed_scales::Position& of = at.scales;
  const CGP::internal::Relaxed_scales::State& best = of.best ? *of.best : of.state;
  const bool has_response = of.response.size() > 0;
  const Eigen::Index own = mesh.own_vertices();
  const auto spins = [&](const Quaternion_vector<double>& all) -> Eigen::MatrixXd {
    return CGP::components(all).leftCols(own);
  };
  const auto row = [&](const Eigen::VectorXd& all) { return all.head(own).transpose(); };
  Search_state to;
  to.numbers = {1. * at.tries,   at.stiffness,          at.shear,          of.way,
                of.room,         1. * of.steps,         1. * of.spent,     of.factored.moved,
                of.state.weight, of.state.excess,       of.best ? 1. : 0., best.weight,
                best.excess,     has_response ? 1. : 0.};
  to.values.resize(16, own);
  to.values << spins(of.state.lambda), row(of.state.rho), row(of.factored.rho),
      row(of.factored.shift), spins(best.lambda), row(best.rho),
      spins(has_response ? of.response : of.state.lambda);
  return to;
}

Search::Position resumed(const Distributed_mesh& mesh, const Search_state& from)
{
  const int own = mesh.own_vertices();
  Eigen::MatrixXd rows(16, mesh.mesh().size_of_vertices());
  rows.leftCols(own) = from.values;
  mesh.update(rows);
  rows.row(6).tail(rows.cols() - own).setZero();  // it is summed over
  const auto spins = [&](Eigen::Index first) {
    Quaternion_vector<double> all(rows.cols());
    CGP::components(all) = rows.middleRows(first, 4);
    return all;
  };
  const std::vector<double>& n = from.numbers;
  Search::Position at;
  at.tries = static_cast<int>(n[0]), at.stiffness = n[1], at.shear = n[2];
  at.scales = {{spins(0), rows.row(4), n[8], n[9]},
               std::nullopt,
               {},
               {rows.row(5), rows.row(6), n[7]},
               n[3],
               n[4],
               static_cast<int>(n[5]),
               static_cast<int>(n[6])};
  if (n[10] > 0) at.scales.best = {spins(7), rows.row(11), n[11], n[12]};
  if (n[13] > 0) at.scales.response = spins(12);
  return at;
}

/// the surface of `CGP::internal::Relaxed_scales`
CGP::Spin_result bounded(const Distributed_mesh& mesh, const Solution_plan& plan,
                         const Eigen::VectorXd& areas, const Eigen::VectorXd& rho,
                         const Spin_request& request, const Search_state& start, const Save& save,
                         const Go_further& go_further)
{
  const Faces_of_part faces{mesh};
  CGP::internal::Dirac_system system(faces, {}, "spin", part_solvers(mesh, plan), mesh.part());
  CGP::internal::Scale_control control;
  control.bound = request.bound;
  std::optional<Search> search;
  CGP::internal::Relaxed_scales_options options;
  options.spins.negligible = Search::negligible(system, control);
  options.between_steps = [&] {
    if (const auto position = search->position()) save(saved(mesh, *position));
  };
  search.emplace(system, rho, control, options);
  const auto surface = [&](CGP::internal::Dirac_solution found) -> CGP::Spin_result {
    CGP::Spin_report report;
    static_cast<CGP::internal::Dirac_evidence&>(report) = found;
    static_cast<CGP::internal::Dirac_evidence::Seconds&>(report.seconds) = found.seconds;
    report.limits = request.limits;
    if (report.cancelled) return {{}, std::move(found.lambda), report};
    return surface_of(mesh, plan, areas, std::move(found.lambda), report);
  };
  const auto goes_further = [&](const CGP::Eigensolver_progress& progress) {
    return broadcast(rank() == 0 && go_further(progress));
  };
  CGP::Spin_result result = start.values.cols() > 0
                                ? search->resumed(resumed(mesh, start), rho, surface, goes_further)
                                : search->surface({}, rho, surface, goes_further);
  if (result.report.cancelled) return result;
  result.report.eigenvalue = system.mean(search->scales().spins().rho() - rho);
  result.report.scales = search->kept(rho);
  return result;
}

}  // namespace

Distributed_result transform(const Distributed_mesh& mesh, const Solution_plan& plan,
                             const Eigen::VectorXd& rho, const Spin_request& request,
                             const Search_state& start, const Save& save,
                             const Go_further& go_further)
{
  const CGP::internal::Quiet_petsc quiet;
  Eigen::MatrixXd areas = CGP::vertex_areas(mesh.mesh()).transpose();
  mesh.update(areas);
  CGP::Spin_result found =
      request.bound
          ? bounded(mesh, plan, areas.transpose(), rho, request, start, save, go_further)
          : unbounded(mesh, plan, areas.transpose(), rho, request, start, save, go_further);
  Distributed_result result;
  CGP::Spin_report& report = result.report = found.report;
  if (report.cancelled) return result;
  CGP::internal::Stopwatch watch;
  result.quality = quality(mesh, found.positions);
  if (report.converged)
    report.realised_curvature = realised_curvature(mesh, plan, found.positions, rho);
  result.positions = found.positions.leftCols(mesh.own_vertices());
  report.seconds.certificate += watch.lap();
  return result;
}

}  // namespace conformal::mpi
