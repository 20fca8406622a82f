// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Distributed_eigenvector.h"

#include "Counted_faces.h"
#include "Distributed_matrix.h"

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Quaternionic_linear_algebra/adapters/Petsc_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/adapters/Slepc_eigensolver_traits.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace conformal::mpi {
namespace {

using CGP::Curvature_potential;
using CGP::Quaternion;
using CGP::Quaternion_vector;

/// \brief The eigenvector of X for t rho + gamma, and gamma, followed from lambda = 1 at t = 0 to
/// t = 1. Each stage goes as far as the vector stays near to that before it.
class Eigenvector {
 public:
  Eigenvector(const Distributed_mesh& mesh, const Eigen::VectorXd& rho, Eigen::VectorXd areas,
              const Branch_state& start)
      : gamma(start.gamma),
        m_mesh(mesh),
        m_rho(rho),
        m_areas(std::move(areas)),
        m_matrix(mesh),
        m_own(mesh.own_vertices()),
        m_area(sum(m_areas.head(m_own).sum())),
        m_t(start.t),
        m_step(start.step)
  {
    lambda = Quaternion_vector<double>::Constant(mesh.mesh().size_of_vertices(), {1, 0, 0, 0});
    if (start.spins.cols() > 0) set(start.spins);
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
      m_grids.reset();
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
  double gamma;

  /// rho + gamma
  Eigen::VectorXd shifted() const { return m_t * m_rho.array() + gamma; }

  /// makes the mean of lambda real, and that of |lambda|^2 one
  void normalize()
  {
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    double square = 0;
    for (int v = 0; v < m_own; ++v) {
      const Quaternion<double> q = lambda[v];
      mean += m_areas[v] * Eigen::Vector4d(q.w, q.x, q.y, q.z);
      square += m_areas[v] * CGP::squared_norm(q);
    }
    mean = sum_of(mean);
    const double length = std::sqrt(sum(square) / m_area) * mean.norm();
    const Quaternion<double> turn{mean[0] / length, -mean[1] / length, -mean[2] / length,
                                  -mean[3] / length};
    for (auto& q : lambda) q = q * turn;
  }

 private:
  /// makes shift and vector stationary together
  void refine(double tolerance, int max_passes, const CGP::Dirac_options& options, const Save& save,
              const Go_further& go_further, CGP::Spin_report& report)
  {
    for (int pass = 0; pass < max_passes; ++pass) {
      assemble(report);
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

  double root(int v) const { return std::sqrt(m_areas[v] * unit()); }

  /// K = M^-1/2 X M^-1/2 / unit + shift, and grids for it where there are none: others that are for
  /// a K nearby will do
  void assemble(CGP::Spin_report& report)
  {
    CGP::internal::Stopwatch watch;
    const double shift = 1e-3;  // X may be singular
    const auto X = CGP::dirac_energy(m_mesh.mesh(), Curvature_potential::on_vertices(shifted()));
    const auto scaled = [&](int i, int j, const auto& a) { return a / (root(i) * root(j)); };
    m_matrix.set(X, [&](int i, int j, const Quaternion<double>& a) {
      Quaternion<double> k = scaled(i, j, a);
      if (i == j) k.w += shift;
      return k;
    });
    report.seconds.assembly += watch.lap();
    if (m_grids) return;
    Distributed_matrix<double> real(m_mesh);
    real.set(X, [&](int i, int j, const Quaternion<double>& a) {
      return scaled(i, j, a).w + (i == j ? shift : 0);
    });
    set_smooth_vector(real);
    m_grids.emplace(m_matrix.get(), real.get(), 2);
    ++report.factorizations;
    report.seconds.factorization += watch.lap();
  }

  /// Constants are in the kernel of X for rho = 0, so they are what grids have to represent, and
  /// masses turn them to this.
  void set_smooth_vector(const Distributed_matrix<double>& real) const
  {
    const Petsc_vec v = real.make_vector();
    with_values(v.get(), [&](PetscScalar* values) {
      for (int i = 0; i < m_own; ++i) values[i] = root(i);
    });
    check_petsc(VecNormalize(v.get(), nullptr));
    const Vec vector = v.get();
    CGP::internal::Petsc_handle<MatNullSpace, MatNullSpaceDestroy> space;
    check_petsc(MatNullSpaceCreate(PETSC_COMM_WORLD, PETSC_FALSE, 1, &vector, space.renew()));
    check_petsc(MatSetNearNullSpace(real.get(), space.get()));
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
    CGP::internal::Slepc_lobpcg<decltype(ask)> slepc(m_matrix.get(), m_grids->multigrid(), own,
                                                     ask);
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
    normalize();
    report.residual = slepc.estimate();
    report.iterations += slepc.iterations();
    report.solves += 2 * slepc.iterations();
    report.cancelled = slepc.is_cancelled();
    report.seconds.eigenvectors += watch.lap();
  }

  Branch_state state() const
  {
    return {m_t, m_step, gamma, CGP::components(lambda).leftCols(m_own)};
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
    const Counted_faces faces{m_mesh};
    const auto forms = CGP::dirac_forms(faces, Curvature_potential::on_vertices(shifted()),
                                        CGP::Block<Quaternion<double>>(lambda));
    return sum(forms.dirac(0, 0).w) / sum(forms.mass(0, 0).w);
  }

  /// the derivative of gamma by t: minus a mean of rho
  double quotient_slope() const
  {
    const Counted_faces faces{m_mesh};
    const CGP::Block<Quaternion<double>> vector(lambda);
    const auto with = CGP::dirac_forms(faces, Curvature_potential::on_vertices(m_rho), vector);
    const auto without = CGP::dirac_forms(
        faces, Curvature_potential::on_vertices(Eigen::VectorXd::Zero(m_rho.size())), vector);
    return sum(with.dirac(0, 0).w - without.dirac(0, 0).w) / sum(without.mass(0, 0).w);
  }

  const Distributed_mesh& m_mesh;
  const Eigen::VectorXd& m_rho;
  const Eigen::VectorXd m_areas;
  Distributed_matrix<Quaternion<double>> m_matrix;
  std::optional<CGP::internal::Petsc_multigrid> m_grids;
  int m_own;
  double m_area, m_t, m_step;
};

}  // namespace

Quaternion_vector<double> eigenvector(const Distributed_mesh& mesh, const Eigen::VectorXd& rho,
                                      const Eigen::VectorXd& areas,
                                      const CGP::Dirac_options& options, const Branch_state& start,
                                      const Save& save, const Go_further& go_further,
                                      CGP::Spin_report& report)
{
  Eigenvector vector(mesh, rho, areas, start);
  vector.solve(options, save, go_further, report);
  report.eigenvalue = vector.gamma;
  report.dirac_residual =
      dirac_misfit(mesh, Curvature_potential::on_vertices(vector.shifted()), vector.lambda);
  return std::move(vector.lambda);
}

}  // namespace conformal::mpi
