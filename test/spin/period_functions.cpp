// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/period_functions.h
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/closed_step.h>
#include <Conformal_geometry_processing/spin/period_functions.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include "spin/moebius_images.h"

namespace cgp_test::period_functions_tests {

const std::vector<Circle> holes{{{.2, .1}, .3}, {{-.45, -.3}, .2}};

/// \brief the greatest difference of the derivative from central differences, relative to the
/// greatest of them. It is of the discretisation: the spins solve the equation up to it.
double derivative_error(const Moebius_image& moebius, const Eigen::Vector3d& tnb)
{
  CGP::Spin_transformation t(moebius.source, {moebius.directions(tnb)});
  CGP::Dirac_options options;
  options.tolerance = 1e-11;
  const auto step = [&](const Curvature_potential& rho) {
    return CGP::internal::measured_step(t, rho, options, CGP::internal::Always_go_further());
  };
  const Curvature_potential rho = moebius.rho();
  const auto& constraints = t.exactness(rho.on);
  CGP::internal::Closed_step first = step(rho);
  const Eigen::MatrixXd z = CGP::internal::period_derivative(t, first);
  const Eigen::VectorXd change =
      potential_on_vertices(moebius.source, [](const Eigen::Vector3d& p) {
        return std::sin(2 * p.x() + 1) + p.y();
      }).values;
  const double small = 1e-4;
  const auto periods = [&](double s) -> Eigen::MatrixXd {
    return constraints.forms.coefficients(constraints.weights,
                                          step({rho.on, rho.values + s * change}).edges);
  };
  const Eigen::MatrixXd measured = (periods(small) - periods(-small)) / (2 * small);
  const Eigen::VectorXd told =
      2 * t.domain().unit() * z.transpose() * constraints.areas.cwiseProduct(change);
  return (told - measured.reshaped<Eigen::RowMajor>()).cwiseAbs().maxCoeff() /
         measured.cwiseAbs().maxCoeff();
}

TEST(Period_functions, are_the_exactness_functions_at_the_identity)
{
  const Mesh_view mesh = random_domain(.15, 3, holes);
  for (const bool on_faces : {false, true}) {
    CGP::Spin_transformation t(mesh, {Boundary_condition::binormals()});
    const auto on = on_faces ? Curvature_potential::On::faces : Curvature_potential::On::vertices;
    const auto& constraints = t.exactness(on);
    t.system().prepare_response();
    const auto one =
        CGP::Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 0, 0, 0});
    const Curvature_potential zero{on, Eigen::VectorXd::Zero(constraints.areas.size())};
    const Eigen::MatrixXd z = CGP::internal::period_functions(
        t.system().surface(), constraints.forms, zero, one,
        [&](const CGP::Block<Quaternion<double>>& c) { return t.system().response(c); });
    EXPECT_LT((z - constraints.functions).norm(), 1e-9 * z.norm());
  }
}

TEST(Period_functions, tell_how_periods_change_where_the_boundary_is_turned)
{
  for (const Eigen::Vector3d& tnb : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1)}) {
    EXPECT_LT(derivative_error(Moebius_image(.16, 3, holes), tnb), .15) << tnb.transpose();
    EXPECT_LT(derivative_error(Moebius_image(.08, 3, holes), tnb), .06) << tnb.transpose();
  }
}

}  // namespace cgp_test::period_functions_tests
