// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Framed_surface.h
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Framed_surface.h>

#include <Eigen/Geometry>

#include <limits>

#include "spin/boundary_tools.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::framed_surface_tests {

using CGP::internal::Framed_surface;

Mesh_view moved_away(const Mesh_view& mesh)
{
  return mapped(mesh, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    return 1e6 * p + Eigen::Vector3d(3e6, -5e6, 1e6);
  });
}

std::string refusal(const Mesh_view& mesh, std::optional<double> mollification)
{
  return refusal_of([&] { Framed_surface::require(mesh, mollification, "f"); });
}

TEST(Framed_surface, is_the_mesh_around_the_origin_in_units_of_its_size)
{
  const Mesh_view mesh = moved_away(icosphere(2));
  const Framed_surface domain(mesh, std::nullopt);
  EXPECT_EQ(domain.positions(), mesh.positions());
  EXPECT_FALSE(domain.is_mollified());
  EXPECT_LT(domain.mesh().positions().cwiseAbs().maxCoeff(), 2);
  EXPECT_GT(domain.mesh().positions().cwiseAbs().maxCoeff(), .1);
  EXPECT_NEAR(domain.unit() * domain.unit() * area(domain.mesh()) / area(mesh), 1, 1e-12);
  EXPECT_EQ(domain.frame().unit(), domain.unit());
  EXPECT_EQ(domain.surface().size_of_sheets(), mesh.size_of_faces());
  EXPECT_EQ(&domain.surface().positions(), &domain.mesh().positions());
  EXPECT_EQ(&domain.measured(), &domain.mesh());
  const auto none = domain.mollification();
  EXPECT_EQ(none.share, 0);
  EXPECT_EQ(none.measured_faces, 0);
}

TEST(Framed_surface, with_mollification_is_the_triangulation_measured_on_well_shaped_faces)
{
  const Mesh_view clean = icosphere(2), mesh = moved_away(with_thin_faces(clean, 0));
  const Framed_surface domain(mesh, 1e-6);
  EXPECT_TRUE(domain.is_mollified());
  EXPECT_GT(domain.surface().size_of_sheets(), mesh.size_of_faces());
  EXPECT_EQ(domain.surface().size_of_faces(), mesh.size_of_faces());
  EXPECT_NE(&domain.measured(), &domain.mesh());
  const int thin = mesh.size_of_vertices() - clean.size_of_vertices();
  const auto report = domain.mollification();
  EXPECT_EQ(report.share, 1e-6);
  EXPECT_EQ(report.thin_faces, thin);
  EXPECT_EQ(report.longer_edges, mesh.size_of_edges());
  EXPECT_EQ(report.measured_faces, mesh.size_of_faces() - thin);
  EXPECT_EQ(report.measured_faces, domain.measured().size_of_faces());
  EXPECT_GT(report.added_length, 1e-8 * mean_edge_length(mesh));
  EXPECT_LT(report.added_length, 1e-5 * mean_edge_length(mesh));
  EXPECT_GT(report.flipped_edges, 0);
}

TEST(Framed_surface, that_moves_keeps_its_references)
{
  const Mesh_view before = icosphere(2), after = moved_away(radially_perturbed(before, .2));
  Framed_surface domain(before, std::nullopt);
  const CGP::Surface_ref surface = domain.surface();
  domain.set_positions(after.positions());
  const Framed_surface expected(after, std::nullopt);
  EXPECT_EQ(domain.positions(), after.positions());
  EXPECT_EQ(domain.unit(), expected.unit());
  EXPECT_EQ(surface.positions(), expected.mesh().positions());
  EXPECT_EQ(CGP::vertex_areas(surface), CGP::vertex_areas(expected.surface()));
}

TEST(Framed_surface, takes_closed_forms_along)
{
  const Mesh_view mesh = perturbed(btorus(12), .04);
  const Eigen::MatrixXd generators = CGP::closed_generators(mesh);
  const Framed_surface plain(mesh, std::nullopt), robust(mesh, 1e-6);
  EXPECT_TRUE(plain.has_loops());
  EXPECT_FALSE(Framed_surface(icosphere(1), std::nullopt).has_loops());
  EXPECT_EQ(Framed_surface(icosphere(1), std::nullopt).forms().cols(), 0);
  EXPECT_EQ(Framed_surface(icosphere(1), 1e-6).forms().cols(), 0);
  EXPECT_EQ(plain.forms(), generators);
  EXPECT_EQ(robust.forms().rows(), robust.surface().size_of_edges());
  EXPECT_EQ(robust.forms().cols(), 2);
}

TEST(Framed_surface, measures_by_how_much_prescribed_directions_are_missed)
{
  const Mesh_view mesh = disk(3);
  const double angle = .1;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).matrix();
  for (const std::optional<double> mollification : {std::optional<double>(), {1e-6}}) {
    const Framed_surface domain(mesh, mollification);
    const CGP::internal::Dirac_system dirac(domain.surface(), Boundary_condition::tangents());
    const auto errors = [&](const Points& p) {
      return domain.direction_errors(*dirac.directions(), p, dirac.directions()->targets());
    };
    EXPECT_LT(errors(domain.mesh().positions()).maxCoeff(), 1e-7);
    EXPECT_NEAR(errors(turn * domain.mesh().positions()).mean(), angle, 1e-6);
  }
}

TEST(Framed_surface, requires_areas_or_mollification)
{
  const Mesh_view clean = icosphere(1), thin = with_thin_faces(clean, 0);
  const Mesh_view line(clean.positions().array().colwise() * Eigen::Array3d(1, 0, 0),
                       clean.corners());
  EXPECT_EQ(refusal(clean, std::nullopt), "");
  EXPECT_EQ(refusal(clean, 1e-6), "");
  EXPECT_NE(refusal(thin, std::nullopt).find("of area zero"), std::string::npos);
  EXPECT_EQ(refusal(thin, 1e-6), "");
  EXPECT_NE(refusal(line, 1e-6).find("all faces have area zero"), std::string::npos);
  for (const double share : {0., 1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_NE(refusal(clean, share).find("between 0 and 1"), std::string::npos);
}

TEST(Framed_surface, requires_finite_coordinates_of_other_positions)
{
  const Mesh_view thin = with_thin_faces(icosphere(1), 0);
  const auto refusal = [](const Mesh_view& mesh, bool is_mollified) {
    return refusal_of([&] { Framed_surface::require_faces(mesh, is_mollified, "f"); });
  };
  EXPECT_NE(refusal(thin, false).find("of area zero"), std::string::npos);
  EXPECT_EQ(refusal(thin, true), "");
  Points p = thin.positions();
  p(1, 7) = std::numeric_limits<double>::infinity();
  for (const bool is_mollified : {false, true})
    EXPECT_NE(refusal({p, thin.corners()}, is_mollified).find("vertex 7"), std::string::npos);
}

}  // namespace cgp_test::framed_surface_tests
