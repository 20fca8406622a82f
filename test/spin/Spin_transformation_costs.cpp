// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
// Tests include/Conformal_geometry_processing/spin/Conformal_deformation.h
// Tests include/Conformal_geometry_processing/spin/Nearest_spin_transformation.h
#include <Conformal_geometry_processing/spin/Conformal_deformation.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>

#include <gtest/gtest.h>

#include "boundary_tools.h"
#include "support/Counted_solver_traits.h"
#include "support/control_points.h"
#include "support/limbs.h"
#include "support/thin_faces.h"
#include "support/with_solvers.h"

namespace cgp_test::spin_transformation_costs_tests {

/// Reports count every factorization of X, and every solve with it.

Curvature_potential waves(const Mesh_view& mesh, double amplitude)
{
  return potential_on_faces(mesh, [&](const Eigen::Vector3d& p) {
    return amplitude * (std::sin(3 * p.x() + .5) * std::cos(2 * p.y()) + .6 * std::sin(4 * p.z()));
  });
}

void expect_counted(const CGP::Spin_report& report)
{
  EXPECT_GT(report.solves, 0);
  EXPECT_EQ(report.factorizations, Counted_solver_traits::quaternionic.factorizations);
  EXPECT_EQ(report.solves, Counted_solver_traits::quaternionic.solves);
}

/// of the first transformation, and of one more
void expect_counted(const Mesh_view& mesh, double amplitude,
                    const CGP::Spin_transformation_options& options = {})
{
  CGP::Spin_transformation transformation(mesh, with_solvers<Counted_solver_traits>(options));
  for (const double factor : {1., .9}) {
    Counted_solver_traits::reset();
    expect_counted(transformation.transform(waves(mesh, factor * amplitude)).report);
  }
}

TEST(Spin_transformation_costs, are_all_in_the_report)
{
  for (const double amplitude : {.3, 1., 3.}) {
    expect_counted(perturbed(icosphere(3), .02), amplitude);
    expect_counted(dumbbell(2), amplitude);
    expect_counted(jittered_disk(8, .2), amplitude);
  }
}

/// the default solvers, of which those of X tell how many hold a factor
struct Watched_solver_traits {
  inline static int held = 0;     // factors of X
  inline static int beside = -1;  // these, at the last factorization of another matrix

  template <class Scalar>
  class Solver : public CGP::Default_solver_traits::Solver<Scalar> {
    using Parent = CGP::Default_solver_traits::Solver<Scalar>;

   public:
    auto factorize(const CGP::Hermitian_sparse_matrix<Scalar>& A, const Eigen::VectorXd& shift)
    {
      hold(true);
      return Parent::factorize(A, shift);
    }
    void release()
    {
      hold(false);
      Parent::release();
    }

   private:
    void hold(bool holds)
    {
      if (std::is_same_v<Scalar, double>) {
        beside = held;
      } else {
        held += static_cast<int>(holds) - static_cast<int>(m_holds);
        m_holds = holds;
      }
    }

    bool m_holds = false;
  };
};

TEST(Spin_transformation_costs, are_those_of_no_factor_of_X_where_the_surface_is_judged)
{
  CGP::Spin_transformation_options options;
  options.scales.bound = 2;
  options = with_solvers<Watched_solver_traits>(options);
  const Mesh_view mesh = perturbed(icosphere(3), .02);
  const CGP::Spin_report report =
      CGP::Spin_transformation(mesh, options).transform(waves(mesh, 1)).report;
  EXPECT_GE(report.factorizations, 1);
  EXPECT_EQ(Watched_solver_traits::beside, 0);
}

TEST(Spin_transformation_costs, are_all_in_the_report_of_other_problems)
{
  CGP::Spin_transformation_options generalized, smallest;
  generalized.dirac.problem = CGP::Dirac_options::Eigenproblem::generalized;
  smallest.dirac.branch = CGP::Dirac_options::Branch::smallest;
  for (const CGP::Spin_transformation_options& options : {generalized, smallest})
    for (const double amplitude : {.3, 1.}) {
      expect_counted(icosphere(3), amplitude, options);
      expect_counted(dumbbell(2), amplitude, options);
    }
}

TEST(Spin_transformation_costs, are_all_in_the_report_of_intrinsic_triangulations)
{
  CGP::Spin_transformation_options options;
  options.mollification = 1e-3;
  expect_counted(with_thin_faces(icosphere(3), 1e-6), 1, options);
  expect_counted(with_thin_faces(btorus(16), 1e-6), 1, options);
}

TEST(Spin_transformation_costs, are_all_in_the_report_of_new_positions_of_the_boundary)
{
  const Mesh_view mesh = cap_from_disk(jittered_disk(8, .2), 1);
  const auto [p, n] = [&] {
    return std::pair(at_boundary(mesh,
                                 [](const Eigen::Vector3d& q, const auto&) -> Eigen::Vector3d {
                                   return Eigen::Vector3d(1.2 * q.x(), q.y(), q.z());
                                 }),
                     at_boundary(mesh, [](const auto&, const auto& frame) -> Eigen::Vector3d {
                       return frame.col(1);
                     }));
  }();
  for (const double weight : {10., std::numeric_limits<double>::infinity()}) {
    CGP::Spin_transformation_options options;
    options.boundary = Boundary_condition::positions(p, n, weight);
    expect_counted(mesh, .5, options);
  }
}

TEST(Spin_transformation_costs, are_all_in_the_report_of_control_points)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(3), .02), jittered_disk(8, .2), btorus(16)}) {
    CGP::internal::Conformal_deformation_options options;
    options.surface = with_solvers<Counted_solver_traits>();
    CGP::internal::Conformal_deformation deformation(mesh, options);
    for (const double way : {.1, .12}) {
      Counted_solver_traits::reset();
      expect_counted(deformation.deform(one_moved(mesh, 5, way)).report);
    }
  }
}

TEST(Spin_transformation_costs, are_all_in_the_report_of_the_nearest_one)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(2), .02), btorus(8)})
    for (const bool keep_curvature : {false, true}) {
      CGP::Quaternion_vector<double> mu(mesh.size_of_vertices());
      for (int v = 0; v < mesh.size_of_vertices(); ++v) {
        const double angle = .3 * mesh.position(v).z();
        mu[v] = {std::cos(angle), -std::sin(angle), 0, 0};
      }
      CGP::Nearest_spin_options options;
      options.keep_curvature = keep_curvature;
      options.surface = with_solvers<Counted_solver_traits>();
      Counted_solver_traits::reset();
      CGP::Nearest_spin_transformation nearest(mesh, mu, "test", options);
      expect_counted(nearest.transform().report);
    }
}

}  // namespace cgp_test::spin_transformation_costs_tests
