// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Moebius_balancing.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/algebra/Moebius_map.h>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "support/decompositions.h"
#include "support/handlebodies.h"
#include "support/meshes.h"

#include <limits>

namespace cgp_test::moebius_balancing_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Moebius_balancing;
using Eigen::Vector3d;

/// the unit sphere after (f^-1 - c)^-1 with |c| = .44
Mesh_view unbalanced_sphere()
{
  return mapped(icosphere(4), [](const Vector3d& f) -> Vector3d {
    const Vector3d g = -f / f.squaredNorm() - Vector3d(.3, .2, -.25);
    return -g / g.squaredNorm();
  });
}

Moebius_balancing towards(const Mesh_view& mesh)
{
  return Moebius_balancing(CGP::vertex_areas(mesh));
}

Vector3d centroid(const Mesh_view& mesh)
{
  Vector3d sum = Vector3d::Zero();
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) sum += mesh.double_area_vector(f).norm() / 6 * mesh.position(v);
  return sum / area(mesh);
}

template <class Call>
std::string message(Call call)
{
  try {
    call();
  } catch (const CGP::Precondition_error& e) {
    return e.what();
  }
  return "";
}

TEST(Moebius_balancing, finds_the_inversion_exactly_in_a_few_quadratic_steps)
{
  const Moebius_balancing balancing = towards(icosphere(4));
  Mesh_view mesh = unbalanced_sphere();
  double imbalance = balancing.imbalance(mesh);
  EXPECT_NEAR(imbalance, .498, 1e-3);
  const double h = mean_edge_length(icosphere(4));
  for (const double below : {3e-2, 2e-4, 1e-6, 1e-9}) {
    mesh.set_positions(balancing.balanced(mesh));
    EXPECT_LT(balancing.imbalance(mesh), below);
    // quadratic, up to the difference between areas of flat faces and of the smooth sphere
    EXPECT_LT(balancing.imbalance(mesh), (.2 * imbalance + h * h) * imbalance);
    imbalance = balancing.imbalance(mesh);
  }
  EXPECT_LT(CGP::length_cross_ratio_change(icosphere(4), mesh.positions()).max, 1e-11);
  EXPECT_LT(CGP::quasi_conformal_error(icosphere(4), mesh.positions()).max, 1 + 1e-9);
}

TEST(Moebius_balancing, is_the_same_in_all_units)
{
  const Moebius_balancing balancing = towards(icosphere(4));
  const Mesh_view mesh = unbalanced_sphere();
  const CGP::Points wanted = balancing.balanced(mesh);
  ASSERT_GT((wanted - mesh.positions()).norm(), .1 * wanted.norm());
  for (const double unit : {1e-120, 1e120}) {
    Mesh_view other = mesh;
    other.set_positions(unit * mesh.positions());
    EXPECT_LT((balancing.balanced(other) / unit - wanted).norm(), 1e-12 * wanted.norm()) << unit;
  }
}

TEST(Moebius_balancing, comes_close_by_curvature_alone)
{
  const Moebius_balancing balancing = towards(icosphere(4));
  Mesh_view mesh = unbalanced_sphere();
  CGP::Spin_transformation transformation(mesh);
  for (const double below : {.14, .042, .039}) {
    transformation.set_positions(mesh.positions());
    const Eigen::VectorXd rho =
        Moebius_balancing::curvature_change(balancing.step(mesh), CGP::vertex_normals(mesh));
    mesh.set_positions(
        transformation.transform(CGP::Curvature_potential::on_vertices(rho)).positions);
    EXPECT_LT(balancing.imbalance(mesh), below);
  }
}

TEST(Moebius_balancing, changes_lengths_and_curvatures_as_the_inversion_does_to_first_order)
{
  const Mesh_view mesh = bumpy_sphere(4);
  const Vector3d direction = Vector3d(2, -1, 2) / 3;
  const Eigen::VectorXd H = CGP::mean_curvature(mesh), areas = CGP::vertex_areas(mesh);
  std::vector<double> size, length_error, curvature_error;
  for (double e : {.1, .05, .025}) {
    const Vector3d a = e * direction;
    const CGP::Moebius_map map = CGP::Moebius_map::sphere_inversion(a);
    Mesh_view image = mesh;
    image.set_positions(map.transform(mesh.positions()));
    Eigen::VectorXd u = -2 * mesh.positions().transpose() * a;
    u.array() -= CGP::vertex_areas(image).dot(u) / area(image);
    const Eigen::VectorXd scale =
        CGP::components(map.spins(mesh.positions())).colwise().squaredNorm().transpose();
    const Eigen::VectorXd change = CGP::mean_curvature(image).cwiseProduct(scale) - H;
    const Eigen::VectorXd rho = Moebius_balancing::curvature_change(
        a, CGP::vertex_normals(mesh, CGP::internal::Normal_weight::angle));
    size.push_back(e);
    length_error.push_back((Moebius_balancing(areas).log_length_scale(image) - u).norm() /
                           u.norm());
    curvature_error.push_back((change - rho).norm() / rho.norm());
  }
  EXPECT_NEAR(slope(size, length_error), 1, .1);
  EXPECT_LT(length_error.back(), .03);
  EXPECT_LT(curvature_error[1], .6 * curvature_error[0]);
  EXPECT_LT(curvature_error.back(), .03);
}

TEST(Moebius_balancing, of_a_balanced_surface_does_exactly_nothing)
{
  for (const Mesh_view& mesh : {icosphere(2), bumpy_sphere(2), torus(2, 1, 20, 10)}) {
    const Moebius_balancing balancing = towards(mesh);
    EXPECT_EQ(balancing.imbalance(mesh), 0);
    EXPECT_EQ(balancing.step(mesh), Vector3d(0, 0, 0));
    EXPECT_EQ(balancing.balanced(mesh), mesh.positions());
  }
}

TEST(Moebius_balancing, keeps_area_and_centroid_and_never_raises_the_imbalance)
{
  const Mesh_view mesh = mapped(bumpy_sphere(3), [](const Vector3d& p) {
    return Vector3d(3 * p.x() + 5, p.y() + .3 * p.x() * p.x(), p.z());
  });
  for (unsigned seed : {1u, 2u, 3u}) {
    const Eigen::VectorXd wild =
        (4 * random_numbers(mesh.size_of_vertices(), seed) + mesh.positions().row(0).transpose())
            .array()
            .exp();
    const Moebius_balancing balancing(wild);
    Mesh_view moved = mesh;
    for (int i = 0; i < 5; ++i) {
      const double before = balancing.imbalance(moved);
      moved.set_positions(balancing.balanced(moved));
      EXPECT_LE(balancing.imbalance(moved), before);
      EXPECT_NEAR(area(moved), area(mesh), 1e-12 * area(mesh));
      EXPECT_LT((centroid(moved) - centroid(mesh)).norm(), 1e-12);
    }
    EXPECT_LT(balancing.imbalance(moved), balancing.imbalance(mesh));
  }
}

TEST(Moebius_balancing, makes_no_step_towards_a_pole_within_two_radii)
{
  const Mesh_view mesh = bumpy_sphere(3);
  const Eigen::VectorXd wild = (20 * mesh.positions().row(0).transpose()).array().exp();
  const double radius = (mesh.positions().colwise() - centroid(mesh)).colwise().norm().maxCoeff();
  EXPECT_NEAR(Moebius_balancing(wild).step(mesh).norm(), .5 / radius, 1e-12);
}

TEST(Moebius_balancing, does_not_depend_on_position_and_units)
{
  const Mesh_view mesh = unbalanced_sphere();
  const Eigen::VectorXd target = CGP::vertex_areas(icosphere(4));
  const Mesh_view moved =
      mapped(mesh, [](const Vector3d& p) { return Vector3d(100 * p + Vector3d(3e4, -2e4, 1e4)); });
  const Moebius_balancing balancing(target), scaled(1e6 * target);
  const Vector3d a = balancing.step(mesh);
  EXPECT_LT((100 * balancing.step(moved) - a).norm(), 1e-9);
  EXPECT_LT((scaled.step(mesh) - a).norm(), 1e-12);
  EXPECT_NEAR(balancing.imbalance(moved), balancing.imbalance(mesh), 1e-9);
  const Points expected = mapped({balancing.balanced(mesh), mesh.corners()}, [](const Vector3d& p) {
                            return Vector3d(100 * p + Vector3d(3e4, -2e4, 1e4));
                          }).positions();
  EXPECT_LT((balancing.balanced(moved) - expected).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(Moebius_balancing, refuses_areas_that_are_not_positive_and_other_meshes)
{
  Eigen::VectorXd target = CGP::vertex_areas(icosphere(1));
  const Moebius_balancing balancing(target, "flow");
  EXPECT_EQ(message([&] { (void)balancing.step(icosphere(0)); }),
            "flow: 42 target areas, one per vertex is needed: 12");
  EXPECT_THROW((void)balancing.imbalance(icosphere(0)), CGP::Precondition_error);
  EXPECT_THROW((void)balancing.balanced(icosphere(0)), CGP::Precondition_error);
  EXPECT_THROW((void)balancing.log_length_scale(icosphere(0)), CGP::Precondition_error);
  for (double bad : {0., -1., std::numeric_limits<double>::infinity()}) {
    target[7] = bad;
    const std::string m = message([&] { Moebius_balancing{target}; });
    EXPECT_NE(m.find("Moebius_balancing: the target area of vertex 7 is "), std::string::npos);
  }
}

Eigen::VectorXd canonical_density(const Mesh_view& mesh)
{
  return CGP::canonical_area_density(mesh,
                                     CGP::Hodge_decomposition(mesh).harmonic_basis().one_forms);
}

Eigen::VectorXd canonical_areas(const Mesh_view& mesh)
{
  return CGP::canonical_vertex_areas(mesh, canonical_density(mesh));
}

Mesh_view inverted(const Mesh_view& mesh, const Eigen::Vector3d& c)
{
  return {CGP::Moebius_map::sphere_inversion(c).transform(mesh.positions()), mesh.corners()};
}

TEST(Canonical_metric, has_the_genus_as_its_area)
{
  for (const Mesh_view& mesh : {torus(2, 1, 20, 10), btorus(24), perturbed(btorus(12), .05)}) {
    EXPECT_NEAR(CGP::face_areas(mesh).dot(canonical_density(mesh)), 1, 1e-10);
    EXPECT_NEAR(canonical_areas(mesh).sum(), 1, 1e-10);
  }
  for (int genus : {2, 3, 7}) {
    EXPECT_NEAR(canonical_areas(holed_block(genus)).sum(), genus, 1e-10);
    EXPECT_NEAR(canonical_areas(smooth_handlebody(genus, 1)).sum(), genus, 1e-10);
  }
}

TEST(Canonical_metric, of_a_torus_of_revolution_is_flat)
{
  // Its forms are d phi and the conjugate one, both of length proportional to 1 / distance.
  const Mesh_view mesh = torus(std::sqrt(2.), 1, 60, 60);
  const Eigen::VectorXd u = canonical_density(mesh);
  Eigen::VectorXd product(u.size());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const Eigen::Vector3d p = (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
    product[f] = u[f] * p.head<2>().squaredNorm();
  }
  EXPECT_LT(product.maxCoeff(), 1.02 * product.mean());
  EXPECT_GT(product.minCoeff(), .98 * product.mean());
}

TEST(Canonical_metric, does_not_change_under_inversions_but_for_the_size_of_faces)
{
  std::vector<double> h, error;
  for (int n : {16, 32, 64}) {
    const Mesh_view mesh = btorus(n);
    const Eigen::VectorXd a = canonical_areas(mesh);
    const Eigen::VectorXd b = canonical_areas(inverted(mesh, {.25, .1, .15}));
    h.push_back(1. / n);
    error.push_back((a - b).lpNorm<1>());
  }
  EXPECT_NEAR(slope(h, error), 2, .15);
  EXPECT_LT(error.back(), 2e-3);
  // where the areas on the surface itself change much
  const Mesh_view mesh = btorus(16), image = inverted(mesh, {.25, .1, .15});
  EXPECT_GT(
      (CGP::vertex_areas(mesh) / area(mesh) - CGP::vertex_areas(image) / area(image)).lpNorm<1>(),
      .3);
}

TEST(Canonical_metric, does_not_depend_on_the_basis)
{
  const Mesh_view mesh = smooth_handlebody(2, 1);
  const CGP::Harmonic_basis basis = CGP::Hodge_decomposition(mesh).harmonic_basis();
  Eigen::Matrix4d A;
  A << random_numbers(16, 1).reshaped(4, 4);
  const Eigen::Matrix4d Q = orthogonal_factor(A);
  const Eigen::VectorXd u = CGP::canonical_area_density(mesh, basis.one_forms),
                        of_others = CGP::canonical_area_density(mesh, basis.one_forms * Q);
  EXPECT_LT((of_others - u).cwiseAbs().maxCoeff(), 1e-13 * u.maxCoeff());
}

TEST(Canonical_metric, as_a_target_undoes_the_inversion_of_a_symmetric_torus)
{
  // Reflections in three planes leave balanced surfaces of this class no inversion but the
  // identity.
  const Mesh_view mesh = torus(std::sqrt(2.), 1, 40, 40);
  const CGP::internal::Moebius_balancing balancing(canonical_areas(mesh));
  EXPECT_LT(balancing.step(mesh).norm(), 1e-3);
  Mesh_view moved = inverted(mesh, {.1, .05, .08});
  for (int i = 0; i < 12; ++i) moved.set_positions(balancing.balanced(moved));
  EXPECT_LT(balancing.step(moved).norm(), 1e-3);
  EXPECT_NEAR(balancing.imbalance(moved), balancing.imbalance(mesh), 1e-3);
}

TEST(Canonical_metric, refuses_spheres)
{
  EXPECT_THROW(canonical_density(icosphere(1)), CGP::Precondition_error);
}

}  // namespace cgp_test::moebius_balancing_tests
