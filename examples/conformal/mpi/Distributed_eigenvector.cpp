// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Distributed_eigenvector.h"

#include "Counted_faces.h"
#include "Distributed_matrix.h"

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Quaternionic_linear_algebra/adapters/Slepc_eigensolver_traits.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace conformal::mpi {
namespace {

using CGP::Curvature_potential;
using CGP::Quaternion;
using CGP::Quaternion_vector;

/// \brief The eigenvector of X for t rho + gamma, and gamma, followed from lambda = 1 at t = 0 to
/// t = 1. Each stage goes as far as the vector stays near to that before it.
class Eigenvector {
 public:
  Eigenvector(const Distributed_mesh& mesh, const Solution_plan& plan, const Eigen::VectorXd& rho,
              Eigen::VectorXd areas, const Search_state& start)
      : m_mesh(mesh),
        m_plan(plan),
        m_rho(rho),
        m_areas(std::move(areas)),
        m_matrix(mesh),
        m_own(mesh.own_vertices()),
        m_area(sum(m_areas.head(m_own).sum()))
  {
    lambda = Quaternion_vector<double>::Constant(mesh.mesh().size_of_vertices(), {1, 0, 0, 0});
    if (start.values.cols() == 0) return;
    set(start.values);
    m_t = start.numbers.at(0), m_step = start.numbers.at(1), gamma = start.numbers.at(2);
  }

  void solve(const CGP::Dirac_options& options, const Save& save, const Go_further& go_further,
             CGP::Spin_report& report)
  {
    const double rough = 1e-2, same_vector = .85, least_step = 1. / 64;
    while (m_t < 1) {
      const auto before = std::pair(lambda, gamma);
      const double start = m_t, slope = quotient_slope();
      m_t = (std::min)(1., m_t + m_step);
      gamma += (m_t - start) * slope;
      m_solver.reset();
      refine((std::max)(rough, options.tolerance), 1, options, {}, go_further, report);
      if (report.cancelled || report.iterations >= options.max_iterations) return;
      if (overlap(m_mesh, m_areas, before.first, lambda) < same_vector && m_step > least_step) {
        std::tie(lambda, gamma) = before;
        m_t = start;
        m_step /= 2;
      } else {
        report.substeps += m_t < 1 ? 1 : 0;
        save(state());
      }
    }
    refine(options.tolerance, 12, options, save, go_further, report);
  }

  /// 4 pi / area
  double unit() const { return 4 * std::acos(-1.) / m_area; }

  Quaternion_vector<double> lambda;  // of the mesh of the part
  double gamma = 0;

  /// rho + gamma
  Eigen::VectorXd shifted() const { return m_t * m_rho.array() + gamma; }

 private:
  /// makes shift and vector stationary together
  void refine(double tolerance, int max_passes, const CGP::Dirac_options& options, const Save& save,
              const Go_further& go_further, CGP::Spin_report& report)
  {
    for (int pass = 0; pass < max_passes; ++pass) {
      assemble(report);
      tolerance = (std::max)(tolerance, m_rounding);
      iterate(tolerance, options.max_iterations, go_further, report);
      const double change = quotient();
      gamma += change;
      report.converged =
          report.residual <= tolerance && std::abs(change) <= tolerance * std::sqrt(unit());
      if (save) save(state());
      if (report.converged || report.cancelled || report.iterations >= options.max_iterations)
        return;
    }
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  double root(int v) const { return std::sqrt(m_areas[v] * unit()); }

  /// K = M^-1/2 X M^-1/2 / unit + shift, and a solver of it where there is none: that of another K
  /// nearby preconditions as well
  void assemble(CGP::Spin_report& report)
  {
    CGP::internal::Stopwatch watch;
    const double shift = 1e-3;  // X may be singular
    const Curvature_potential potential = Curvature_potential::on_vertices(shifted());
    auto K = CGP::dirac_energy(m_mesh.mesh(), potential);
    const CGP::Sparse_pattern& pattern = K.pattern();
    for (int j = 0; j < K.size(); ++j)
      for (int k = pattern.offsets[at(j)]; k < pattern.offsets[at(j + 1)]; ++k) {
        const int i = pattern.indices[at(k)];
        K.value(k) = K.value(k) / (root(i) * root(j));
        if (i == j) K.value(k).w += shift;
      }
    m_matrix.set(K);
    // what products with K lose: the larger the surface, the more
    m_rounding = 4 * std::numeric_limits<double>::epsilon() * largest(CGP::internal::norm_bound(K));
    report.seconds.assembly += watch.lap();
    if (m_solver) return;
    // Constants are in the kernel of X for rho = 0, and masses turn them to this.
    Eigen::VectorXd smooth(m_own);
    for (int v = 0; v < m_own; ++v) smooth[v] = root(v);
    m_solver.emplace(m_mesh, m_plan, m_matrix.get(), K, smooth);
    ++report.factorizations;
    report.seconds.factorization += watch.lap();
  }

  /// lambda times 1 and j: the quaternionic line of one vector
  std::vector<Petsc_vec> initial() const
  {
    const Quaternion<double> j{0, 0, 1, 0};
    std::vector<Petsc_vec> all;
    for (int c = 0; c < 2; ++c) {
      all.push_back(m_matrix.make_vector());
      with_values(all.back().get(), [&](PetscScalar* values) {
        for (int v = 0; v < m_own; ++v, values += 2) {
          const Quaternion<double> q = c == 1 ? lambda[v] * j : lambda[v];
          CGP::internal::Complex_embedding<Quaternion<double>>::to_entries(q * root(v), values);
        }
      });
    }
    return all;
  }

  void iterate(double tolerance, int max_iterations, const Go_further& go_further,
               CGP::Spin_report& report)
  {
    CGP::internal::Stopwatch watch;
    CGP::Eigensolver_options own;
    own.tolerance = tolerance;
    own.max_iterations = (std::max)(max_iterations - report.iterations, 1);
    const auto ask = [&](CGP::Eigensolver_progress progress) {
      progress.iteration += report.iterations;
      return go_further(progress);
    };
    CGP::internal::Slepc_lobpcg<decltype(ask)> slepc(m_matrix.get(), m_solver->preconditioner(),
                                                     own, ask);
    slepc.run(initial());
    const Petsc_vec v = m_matrix.make_vector();
    slepc.vector(0, v.get());
    Eigen::MatrixXd own_parts(4, m_own);
    with_values(v.get(), [&](const PetscScalar* values) {
      for (int i = 0; i < m_own; ++i, values += 2) {
        const auto q = CGP::internal::Complex_embedding<Quaternion<double>>::from_entries(values);
        own_parts.col(i) = Eigen::Vector4d(q.w, q.x, q.y, q.z) / root(i);
      }
    });
    set(own_parts);
    CGP::fix_gauge(lambda, m_areas, m_mesh.part());
    report.residual = slepc.estimate();
    report.iterations += slepc.iterations();
    report.solves += 2 * slepc.iterations();
    report.cancelled = slepc.is_cancelled();
    report.seconds.eigenvectors += watch.lap();
  }

  Search_state state() const
  {
    return {{m_t, m_step, gamma}, CGP::components(lambda).leftCols(m_own)};
  }

  /// takes the spins of the own vertices, 4 x their number, and those of others from their owners
  void set(const Eigen::MatrixXd& own)
  {
    Eigen::MatrixXd parts(4, lambda.size());
    parts.leftCols(m_own) = own;
    m_mesh.update(parts);
    CGP::components(lambda) = parts;
  }

  /// the eigenvalue less gamma
  double quotient() const
  {
    const Counted_faces faces{{m_mesh}};
    const auto forms = CGP::dirac_forms(faces, Curvature_potential::on_vertices(shifted()),
                                        CGP::Block<Quaternion<double>>(lambda));
    return sum(forms.dirac(0, 0).w) / sum(forms.mass(0, 0).w);
  }

  /// the derivative of gamma by t: minus a mean of rho
  double quotient_slope() const
  {
    const Counted_faces faces{{m_mesh}};
    const CGP::Block<Quaternion<double>> vector(lambda);
    const auto with = CGP::dirac_forms(faces, Curvature_potential::on_vertices(m_rho), vector);
    const auto without = CGP::dirac_forms(
        faces, Curvature_potential::on_vertices(Eigen::VectorXd::Zero(m_rho.size())), vector);
    return sum(with.dirac(0, 0).w - without.dirac(0, 0).w) / sum(without.mass(0, 0).w);
  }

  const Distributed_mesh& m_mesh;
  const Solution_plan& m_plan;
  const Eigen::VectorXd& m_rho;
  const Eigen::VectorXd m_areas;
  Distributed_matrix<Quaternion<double>> m_matrix;
  std::optional<Distributed_solver<Quaternion<double>>> m_solver;
  int m_own;
  double m_area, m_t = 0, m_step = 1, m_rounding = 0;
};

}  // namespace

Quaternion_vector<double> eigenvector(const Distributed_mesh& mesh, const Solution_plan& plan,
                                      const Eigen::VectorXd& rho, const Eigen::VectorXd& areas,
                                      const CGP::Dirac_options& options, const Search_state& start,
                                      const Save& save, const Go_further& go_further,
                                      CGP::Spin_report& report)
{
  Eigenvector vector(mesh, plan, rho, areas, start);
  vector.solve(options, save, go_further, report);
  report.eigenvalue = vector.gamma;
  report.dirac_residual = CGP::dirac_misfit(
      mesh.mesh(), Curvature_potential::on_vertices(vector.shifted()), vector.lambda, mesh.part());
  return std::move(vector.lambda);
}

}  // namespace conformal::mpi
