// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/calculus.h>

#include <gtest/gtest.h>

#include "operators/torus_calculus.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"

#include <vector>

namespace cgp_test::calculus_tests {

namespace CGP = Conformal_geometry_processing;

const Function phi{[](double u, double v) { return std::sin(u) + std::cos(u + v); }};
const Field X{{[](double u, double v) { return std::cos(v) + std::sin(2 * u) / 2; }},
              {[](double u, double v) { return std::sin(u - v); }}};
const Field Y{{[](double u, double v) { return std::sin(u + v); }},
              {[](double, double v) { return 1 + std::cos(v); }}};
const Function mean_curvature{[](double, double v) { return (1 + std::cos(v) / width(v)) / 2; }};
const Function gauss_curvature{[](double, double v) { return std::cos(v) / width(v); }};

/// the errors of an operator on three meshes; wrong signs have errors from 1.4 to 2
struct Errors {
  std::vector<double> h, errors;

  double slope() const { return cgp_test::slope(h, errors); }
};

template <class Error>
Errors errors_of(Error error)
{
  Errors e;
  for (int n : {24, 48, 96}) {
    const Torus_sample torus(n);
    e.h.push_back(torus.h());
    e.errors.push_back(error(torus, CGP::internal::Surface_derivative(torus.mesh())));
  }
  return e;
}

void expect_first_order(const Errors& e)
{
  EXPECT_NEAR(e.slope(), 1, 0.1);
  EXPECT_LT(e.errors.back(), 0.05);
}

TEST(Gradient, is_that_of_the_function_linear_on_each_face)
{
  const Mesh_view mesh = jittered_disk(3, 0.3);
  const CGP::internal::Surface_derivative d(mesh);
  const Eigen::VectorXd linear = mesh.positions().transpose() * Eigen::Vector3d(2, -3, 0);
  const Points g = CGP::gradient(d, linear);
  for (Eigen::Index f = 0; f < g.cols(); ++f)
    EXPECT_LT((g.col(f) - Eigen::Vector3d(2, -3, 0)).norm(), 1e-13);
}

TEST(Gradient, converges_on_the_torus)
{
  expect_first_order(errors_of([](const auto& t, const auto& d) {
    return t.error(CGP::gradient(d, t.at_vertices(phi)), t.on_faces(gradient_of(phi)));
  }));
}

TEST(Divergence, converges_on_the_torus)
{
  expect_first_order(errors_of([](const auto& t, const auto& d) {
    return t.error(CGP::divergence(d, t.at_vertices(X)), t.on_faces(divergence_of(X)));
  }));
}

TEST(Curl, converges_on_the_torus)
{
  expect_first_order(errors_of([](const auto& t, const auto& d) {
    return t.error(CGP::curl(d, t.at_vertices(X)), t.on_faces(curl_of(X)));
  }));
}

TEST(Shape_operator, converges_on_the_torus)
{
  expect_first_order(errors_of([](const auto& t, const auto& d) {
    return t.error(CGP::shape_operator(d, t.at_vertices(X)), t.on_faces(shape_operator_of(X)));
  }));
}

TEST(Second_fundamental_form, converges_on_the_torus)
{
  expect_first_order(errors_of([](const auto& t, const auto& d) {
    const Points SX = t.on_faces(shape_operator_of(X)), y = t.on_faces(Y);
    const Eigen::VectorXd expected = SX.cwiseProduct(y).colwise().sum().transpose();
    return t.error(CGP::second_fundamental_form(d, t.at_vertices(X), y), expected);
  }));
}

TEST(First_fundamental_form, is_the_scalar_product)
{
  Points a(3, 1), b(3, 1);
  a << 1, 2, 3;
  b << 4, -5, 6;
  EXPECT_EQ(CGP::first_fundamental_form(a, b)[0], 12);
}

TEST(Dirac_normals, are_exactly_those_of_the_faces)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points N = CGP::dirac_normals(CGP::internal::Surface_derivative(mesh));
  EXPECT_LT((N - CGP::face_normals(mesh)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Dirac_mean_curvature, converges_on_the_torus_with_the_errors_of_the_specification)
{
  const Errors e = errors_of([](const auto& t, const auto& d) {
    return t.error(CGP::dirac_mean_curvature(d, t.normals()), t.on_faces(mean_curvature));
  });
  const double expected[] = {.0356, .0178, .0089};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(e.errors[at(i)], expected[i], 1e-4);
}

TEST(Dirac_gauss_curvature, converges_on_the_torus_with_the_errors_of_the_specification)
{
  const Errors e = errors_of([](const auto& t, const auto& d) {
    const Eigen::VectorXd K = CGP::dirac_gauss_curvature(d, t.normals());
    EXPECT_NEAR(CGP::vertex_areas(t.mesh()).dot(K), 0, 1e-11);
    return t.error(K, t.at_vertices(gauss_curvature));
  });
  EXPECT_NEAR(e.slope(), 2, 0.1);
  EXPECT_NEAR(e.errors[0], 1.6e-2, 5e-4);
  EXPECT_NEAR(e.errors[2], 1.0e-3, 5e-5);
}

TEST(Laplacian, is_the_cotan_laplacian_over_the_areas)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Eigen::VectorXd f = random_numbers(mesh.size_of_vertices(), 1);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(f.size());
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    const Eigen::Vector3d tip = mesh.position(mesh.corners(h / 3)[at(h % 3)]),
                          a = mesh.position(mesh.from(h)) - tip,
                          b = mesh.position(mesh.to(h)) - tip;
    const double flow = a.dot(b) / a.cross(b).norm() / 2 * (f[mesh.from(h)] - f[mesh.to(h)]);
    expected[mesh.from(h)] += flow;
    expected[mesh.to(h)] -= flow;
  }
  expected.array() /= CGP::vertex_areas(mesh).array();
  const Eigen::VectorXd found = CGP::laplacian(CGP::internal::Surface_derivative(mesh), f);
  EXPECT_LT((found - expected).norm(), 1e-12 * expected.norm());
}

TEST(Laplacian, converges_on_the_torus_to_second_order)
{
  const Errors e = errors_of([](const auto& t, const auto& d) {
    const Function div_grad = divergence_of(gradient_of(phi));
    const Function expected{[&](double u, double v) { return -div_grad(u, v); }};
    return t.error(CGP::laplacian(d, t.at_vertices(phi)), t.at_vertices(expected));
  });
  EXPECT_NEAR(e.slope(), 2, 0.1);
}

TEST(Vector_laplacian, is_that_of_hodge_on_the_torus)
{
  const Function div = divergence_of(X), curl = curl_of(X);
  const Field grad_div = gradient_of(div), grad_curl = gradient_of(curl);
  // -grad div X - J grad curl X, with J E_u = E_v and J E_v = -E_u
  const Field expected{{[&](double u, double v) { return -grad_div.a(u, v) + grad_curl.b(u, v); }},
                       {[&](double u, double v) { return -grad_div.b(u, v) - grad_curl.a(u, v); }}};
  const Errors e = errors_of([&](const auto& t, const auto& d) {
    return t.error(CGP::vector_laplacian(d, t.at_vertices(X), t.normals()),
                   t.at_vertices(expected));
  });
  EXPECT_GT(e.slope(), 0.9);
  EXPECT_LT(e.errors.back(), 0.05);
}

TEST(Covariant_derivative, of_a_function_converges_on_the_torus)
{
  expect_first_order(errors_of([](const auto& t, const auto& d) {
    const Points x = t.on_faces(X), gradient = t.on_faces(gradient_of(phi));
    const Eigen::VectorXd expected = x.cwiseProduct(gradient).colwise().sum().transpose();
    return t.error(CGP::covariant_derivative(d, x, t.at_vertices(phi)), expected);
  }));
}

TEST(Covariant_derivative, of_a_vector_field_is_metric_and_has_no_torsion_on_the_torus)
{
  // d<Y, Y>(X) = 2 <del_X Y, Y>
  const Function squares{[](double u, double v) { return Y(u, v).squaredNorm(); }};
  expect_first_order(errors_of([&](const auto& t, const auto& d) {
    const Points x = t.on_faces(X), y = t.on_faces(Y), gradient = t.on_faces(gradient_of(squares));
    const Eigen::VectorXd expected = x.cwiseProduct(gradient).colwise().sum().transpose();
    const Points derivative = CGP::covariant_derivative(d, x, t.at_vertices(Y));
    const Eigen::VectorXd found = 2 * y.cwiseProduct(derivative).colwise().sum().transpose();
    return t.error(found, expected);
  }));
  // curl of X = <del_1 X, E_2> - <del_2 X, E_1>
  expect_first_order(errors_of([&](const auto& t, const auto& d) {
    const auto E = [](int i) {
      return [i](double u, double v) { return Eigen::Vector3d(frame(u, v).col(i)); };
    };
    const Points x = t.at_vertices(X), e1 = t.on_faces(E(0)), e2 = t.on_faces(E(1));
    const Eigen::VectorXd found = (CGP::covariant_derivative(d, e1, x).cwiseProduct(e2) -
                                   CGP::covariant_derivative(d, e2, x).cwiseProduct(e1))
                                      .colwise()
                                      .sum()
                                      .transpose();
    return t.error(found, t.on_faces(curl_of(X)));
  }));
}

TEST(Surface_derivative, of_a_multiple_of_the_normal_is_its_gradient_and_curvature)
{
  // D(b N) = grad b - 2 H b N, the sign of which the text has otherwise
  expect_first_order(errors_of([](const auto& t, const auto& d) {
    const auto bN = [](double u, double v) {
      return Eigen::Vector3d(phi(u, v) * frame(u, v).col(2));
    };
    const auto expected = [](double u, double v) {
      const double along = -2 * mean_curvature(u, v) * phi(u, v);
      return Eigen::Vector3d(gradient_of(phi)(u, v) + along * frame(u, v).col(2));
    };
    const auto q = d(t.at_vertices(bN));
    EXPECT_LT(d.real_part(q).cwiseAbs().maxCoeff(), 1);
    return t.error(Points(CGP::components(q).template bottomRows<3>()), t.on_faces(expected));
  }));
}

TEST(Surface_derivative, takes_values_apart_into_real_tangential_and_normal_parts)
{
  const Mesh_view mesh = icosphere(1);
  const CGP::internal::Surface_derivative d(mesh);
  const auto q = random_quaternions(mesh.size_of_faces(), 3);
  const Eigen::VectorXd a = d.real_part(q), b = d.normal_part(q);
  const Points T = d.tangential_part(q);
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const Eigen::Vector3d n = d.normals().col(f);
    EXPECT_EQ(a[f], q[f].w);
    EXPECT_NEAR(T.col(f).dot(n), 0, 1e-15);
    EXPECT_LT((T.col(f) + b[f] * n - CGP::imaginary_part(q[f])).norm(), 1e-15);
  }
}

}  // namespace cgp_test::calculus_tests
