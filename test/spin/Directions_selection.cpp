// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Conformal_geometry_processing/spin/Directions_selection.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

#include "spin/boundary_tools.h"
#include "support/decompositions.h"
#include "support/dense.h"

namespace cgp_test::directions_selection_tests {

using Q = Quaternion<double>;
using Vectors = CGP::Block<Q>;
using System = CGP::internal::Dirac_system;

/// the equation on a small mesh, and all its eigenpairs by a dense matrix
class Directions_selection : public testing::Test {
 protected:
  void SetUp() override
  {
    CGP::internal::Dirac_evidence::Seconds seconds;
    system.assemble(rho, seconds);
    const CGP::Block<double> one = CGP::Block<double>::Identity(dimension(), dimension());
    const Vectors embedded = basis().embed(one);
    const Eigen::MatrixXd K = form(embedded, system.matrix());
    const Eigen::MatrixXd M = form(embedded, masses());
    const Eigenpairs eigen = symmetric_eigenpairs(K, M);
    values = eigen.values.cwiseMax(0).cwiseSqrt();
    vectors = basis().embed(eigen.vectors.leftCols(4));
  }

  const CGP::internal::Reduced_basis<double>& basis() const { return system.directions()->basis(); }
  const Quaternion_vector<double>& guide() const { return system.directions()->guide(); }
  int dimension() const { return basis().rows().dimension(); }

  CGP::Hermitian_sparse_matrix<Q> masses() const
  {
    CGP::Hermitian_sparse_matrix<Q> M(system.matrix().shared_pattern());
    for (int v = 0; v < M.size(); ++v)
      M.value(M.pattern().offsets[at(v)]) = {system.areas()[v], 0, 0, 0};
    return M;
  }

  Eigen::MatrixXd form(const Vectors& columns, const CGP::Hermitian_sparse_matrix<Q>& A) const
  {
    Vectors images(columns.rows(), columns.cols());
    for (Eigen::Index j = 0; j < columns.cols(); ++j) images.col(j) = A * columns.col(j);
    return basis().coordinates(images);
  }

  /// Re <a, M_V b>
  double product(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b) const
  {
    double sum = 0;
    for (int v = 0; v < a.size(); ++v) sum += system.areas()[v] * dot(a[v], b[v]);
    return sum;
  }

  /// of mean square one, in the direction of the guide
  Quaternion_vector<double> normalized(Quaternion_vector<double> x) const
  {
    const double sign = product(x, guide()) < 0 ? -1 : 1;
    const double factor = sign * std::sqrt(system.areas().sum() / product(x, x));
    for (Q& q : x) q *= factor;
    return x;
  }

  double overlap(int j) const
  {
    return std::abs(product(vectors.col(j), guide())) / std::sqrt(product(guide(), guide()));
  }

  CGP::internal::Dirac_solution solve(
      const CGP::Dirac_options& options,
      const CGP::internal::Go_further& go_further = CGP::internal::Always_go_further())
  {
    CGP::internal::Dirac_solution s;
    system.set_potential(rho, s.seconds);
    CGP::internal::Directions_selection(system, rho, options).solve(s, go_further);
    return s;
  }

  static CGP::Dirac_options exactly()
  {
    CGP::Dirac_options options;
    options.tolerance = 1e-11;
    return options;
  }

  static constexpr double unit = 100;  // far from one, so that powers of lengths show
  const Mesh_view mesh = scaled(perturbed(cap_from_disk(jittered_disk(3, .3), 1), .04), unit);
  const Curvature_potential rho = potential_on_vertices(
      mesh, [](const Eigen::Vector3d& p) { return 2 / unit * std::cos(3 * p.x() / unit); });
  const Boundary_condition tangents =
      Boundary_condition::tangents(enneper_directions(jittered_disk(3, .3), {1, 0, 0}));
  System system{mesh, tangents};
  Eigen::VectorXd values;  // singular values of D - rho, ascending
  Vectors vectors;         // the first four, of mass one
};

TEST_F(Directions_selection, finds_the_smallest_singular_value)
{
  CGP::Dirac_options options = exactly();
  options.branch = CGP::Dirac_options::Branch::smallest;
  const CGP::internal::Dirac_solution s = solve(options);
  ASSERT_TRUE(s.converged);
  EXPECT_NEAR(s.eigenvalue, values[0], 1e-10);
  EXPECT_NEAR(s.energy, values[0] * values[0], 1e-10);
  EXPECT_NEAR(s.gap, values[1] - values[0], 1e-3 / unit);
  EXPECT_LT(greatest_difference(s.lambda, normalized(vectors.col(0))), 1e-8);
}

TEST_F(Directions_selection, finds_the_vector_nearest_to_the_guide)
{
  int nearest = 0;
  for (int j = 1; j < 4; ++j)
    if (overlap(j) > overlap(nearest)) nearest = j;
  const CGP::internal::Dirac_solution s = solve(exactly());
  ASSERT_TRUE(s.converged);
  EXPECT_NEAR(s.eigenvalue, values[nearest], 1e-10);
  double gap = values[nearest + 1] - values[nearest];
  if (nearest > 0) gap = std::min(gap, values[nearest] - values[nearest - 1]);
  EXPECT_TRUE(s.gap == 0 || std::abs(s.gap - gap) < 1e-3 / unit);  // if others were looked for
  EXPECT_NEAR(s.overlap, overlap(nearest), 1e-9);
  EXPECT_LT(greatest_difference(s.lambda, normalized(vectors.col(nearest))), 1e-8);
}

TEST_F(Directions_selection, takes_the_nearest_of_eigenvalue_zero_or_the_smallest)
{
  System self_adjoint(mesh, Boundary_condition::binormals());
  CGP::Dirac_options options = exactly(), smallest = exactly();
  options.branch = CGP::Dirac_options::Branch::zero;
  smallest.branch = CGP::Dirac_options::Branch::smallest;
  int zeros = 0, others = 0;
  for (const double shift : {0., 3., 6., 9., 12., 15., 18.}) {
    const Curvature_potential shifted{rho.on, rho.values.array() + shift / unit};
    const auto s = CGP::solve_dirac_equation(self_adjoint, shifted, options);
    const bool is_zero = std::abs(s.eigenvalue) <= CGP::greatest_zero(mesh);
    is_zero ? ++zeros : ++others;
    if (is_zero) continue;
    EXPECT_NEAR(s.eigenvalue, CGP::solve_dirac_equation(self_adjoint, shifted, smallest).eigenvalue,
                1e-10);
  }
  EXPECT_GT(zeros, 0);
  EXPECT_GT(others, 0);
}

TEST_F(Directions_selection, projects_the_guide_on_what_counts_as_kernel)
{
  CGP::Dirac_options options = exactly();
  options.kernel_tolerance = (values[1] + values[2]) / 2;
  const CGP::internal::Dirac_solution s = solve(options);
  ASSERT_TRUE(s.converged);
  Quaternion_vector<double> expected = Quaternion_vector<double>::Constant(s.lambda.size(), Q{});
  double energy = 0, square = 0;
  for (int j = 0; j < 2; ++j) {
    const double share = product(vectors.col(j), guide());
    energy += share * share * values[j] * values[j];
    square += share * share;
    for (int v = 0; v < expected.size(); ++v) expected[v] += share * vectors(v, j);
  }
  EXPECT_LT(greatest_difference(s.lambda, normalized(expected)), 1e-8);
  EXPECT_NEAR(s.energy, energy / square, 1e-8 * values[1] * values[1]);
}

TEST_F(Directions_selection, is_what_solves_the_equation_with_a_condition_of_directions)
{
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(system, rho, exactly());
  EXPECT_EQ(s.lambda, solve(exactly()).lambda);
  EXPECT_EQ(s.eigenvalue, solve(exactly()).eigenvalue);
}

TEST_F(Directions_selection, gives_gamma_its_sign_where_it_is_an_eigenvalue)
{
  System self_adjoint(mesh, Boundary_condition::binormals());
  const CGP::internal::Dirac_solution s = CGP::solve_dirac_equation(self_adjoint, rho, exactly());
  ASSERT_TRUE(s.converged);
  const Quaternion_vector<double> B = CGP::averaging(mesh) * s.lambda,
                                  D = CGP::dirac(mesh) * s.lambda,
                                  R = CGP::potential_matrix(mesh, rho) * s.lambda;
  double form = 0, mass = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double A = mesh.double_area_vector(f).norm() / 2;
    form += A * dot(B[f], D[f] - R[f]);
    mass += A * squared_norm(B[f]);
  }
  EXPECT_NEAR(s.eigenvalue, form / mass, 1e-12);
  Curvature_potential opposite = rho;
  opposite.values *= -1;
  const double other = CGP::solve_dirac_equation(self_adjoint, opposite, exactly()).eigenvalue;
  EXPECT_LT(s.eigenvalue * other, 0);
}

TEST(Directions_selection_for_binormals, knows_the_distance_to_the_next_eigenvalue_with_its_sign)
{
  const Mesh_view cap = mapped(cap_from_disk(jittered_disk(10, .2), 1.3), [](const auto& p) {
    return Eigen::Vector3d(3 * p.x(), 4 * p.y() + p.x() * p.x(),
                           3 * p.z());  // no eigenvalue is double
  });
  for (const double shift : {-.6, .2, .6}) {
    CGP::Curvature_potential rho = CGP::no_potential(cap);
    rho.values.array() += shift;
    System with_binormals(cap, Boundary_condition::binormals());
    CGP::Dirac_options smallest;
    smallest.branch = CGP::Dirac_options::Branch::smallest;
    const auto s = CGP::solve_dirac_equation(with_binormals, rho, smallest);
    CGP::internal::Dirac_spectrum_options around;
    around.shift = s.eigenvalue;
    const auto spectrum =
        CGP::internal::Dirac_spectral_problem(cap, Boundary_condition::binormals())
            .find(rho, 2, around);
    ASSERT_NEAR(spectrum.eigenvalues[0], s.eigenvalue, .01);  // X mixes less next to gamma
    const double gap = std::abs(spectrum.eigenvalues[1] - spectrum.eigenvalues[0]);
    EXPECT_NEAR(s.gap, gap, .1 * gap) << shift;
  }
}

TEST_F(Directions_selection, answers_to_sources_in_the_space_of_the_condition)
{
  const Quaternion_vector<double> c = random_quaternions(mesh.size_of_vertices(), 3);
  system.prepare_response();
  const Vectors x = system.response(Vectors(c));
  EXPECT_LT(greatest_difference(basis().project(x).col(0), x.col(0)), 1e-12);
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.assemble(CGP::no_potential(mesh), seconds);
  Quaternion_vector<double> image = system.matrix() * x.col(0);
  for (int v = 0; v < image.size(); ++v)
    image[v] += 1e-6 * system.unit() * system.areas()[v] * x(v, 0);
  EXPECT_LT((basis().coordinates(Vectors(image)) - basis().coordinates(Vectors(c))).norm(), 1e-9);
}

TEST_F(Directions_selection, gives_the_same_bits_again)
{
  CGP::Dirac_options options;
  options.kernel_tolerance = (values[1] + values[2]) / 2;
  EXPECT_EQ(solve(options).lambda, solve(options).lambda);
}

TEST_F(Directions_selection, can_be_cancelled)
{
  for (int limit = 0; limit < 4; ++limit) {
    int count = 0;
    const CGP::internal::Dirac_solution s =
        solve(exactly(), [&](const CGP::Eigensolver_progress&) { return count++ < limit; });
    EXPECT_TRUE(s.cancelled);
    EXPECT_EQ(count, limit + 1);
  }
}

TEST_F(Directions_selection, says_so_if_it_has_not_converged)
{
  CGP::Dirac_options options = exactly();
  options.max_iterations = 1;
  EXPECT_FALSE(solve(options).converged);
}

TEST_F(Directions_selection, tells_the_same_error_in_all_units_of_length)
{
  const Mesh_view large = scaled(mesh, 1024);
  System of_large(large, tangents);
  CGP::Dirac_options options = exactly();
  options.max_iterations = 1;
  const CGP::internal::Dirac_solution s =
      CGP::solve_dirac_equation(of_large, Curvature_potential{rho.on, rho.values / 1024}, options);
  const double residual = solve(options).residual;
  EXPECT_GT(residual, 1e-9);
  EXPECT_NEAR(s.residual / residual, 1, 1e-6);
}

TEST_F(Directions_selection, refuses_a_matrix_that_is_not_finite)
{
  Curvature_potential broken = rho;
  broken.values[3] = std::numeric_limits<double>::quiet_NaN();
  CGP::internal::Dirac_evidence::Seconds seconds;
  EXPECT_THROW(system.set_potential(broken, seconds), CGP::Solver_error);
}

}  // namespace cgp_test::directions_selection_tests
