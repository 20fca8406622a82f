// Tests examples/conformal/commands/studio.cpp examples/conformal/studio/Studio_surface.cpp
// Tests examples/conformal/studio/studio_page.cpp examples/conformal/studio/built_in_shapes.cpp
// Tests examples/conformal/report/page_blocks.cpp examples/conformal/input/User_frame.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/studio/Studio_surface.h"

#include "program/support.h"
#include "support/spheres.h"

#include "conformal/input/User_frame.h"
#include "conformal/studio/built_in_shapes.h"
#include "conformal/studio/studio_page.h"
#include "conformal/studio/studio_page_text.h"

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace cgp_test::studio_tests {

using namespace program_test;
namespace CGP = Conformal_geometry_processing;
using conformal::Studio_surface;

class Studio : public Program {
 protected:
  Studio() { write("a.off", off(cgp_test::bumpy_sphere(2))); }

  bool is_built_in() const { return conformal::studio_page_begin[0] != '\0'; }
};

/// a soft bump at the side, in the user's frame
Eigen::VectorXd bump(const CGP::Mesh_view& mesh, double amplitude)
{
  const conformal::User_frame frame(mesh);
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v) {
    const Eigen::Vector3d p = frame(mesh.position(v));
    rho[v] = amplitude * std::exp(-4 * (p - Eigen::Vector3d(.5, 0, 0)).squaredNorm());
  }
  return rho;
}

TEST_F(Studio, is_written_or_refused_with_the_reason)
{
  const Program_run r = run("studio a.off -o page.html");
  if (is_built_in()) {
    EXPECT_EQ(r.code, 0) << r.err;
    const std::string page = content(path("page.html"));
    EXPECT_NE(page.find("\"file\":\"a.off\""), std::string::npos);
    EXPECT_NE(page.find("id=\"squares-0\""), std::string::npos);
    EXPECT_EQ(page.find("id=\"squares-1\""), std::string::npos);
  } else {
    EXPECT_TRUE(fails(r, 2, conformal::studio_page_fault));
    EXPECT_TRUE(fails(r, 2, conformal::installed_studio_page()));
    EXPECT_TRUE(fails(r, 2, "--advanced page=FILE"));
    EXPECT_TRUE(fails(r, 2, "minutes"));
    EXPECT_TRUE(fails(r, 2, "-DCGP_STUDIO=ON -DCGP_HTML_REPORT=ON && cmake --build "));
    EXPECT_FALSE(has("page.html"));
  }
  EXPECT_EQ(temporary_files(), 0u);
}

TEST_F(Studio, offers_four_shapes_without_an_input)
{
  if (!is_built_in()) return;
  EXPECT_EQ(run("studio -o page.html").code, 0);
  const std::string page = content(path("page.html"));
  EXPECT_NE(page.find("id=\"origin-3\""), std::string::npos);
}

TEST_F(Studio, counts_the_vertices_of_the_file)
{
  if (!is_built_in()) return;
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(1);
  write("loose.off", off(mesh, "9 9 9\n", 1));
  const std::string count = std::to_string(mesh.size_of_vertices() + 1);
  for (const std::string option : {"", " --repair"}) {
    EXPECT_EQ(run("studio loose.off -o page.html" + option).code, 0);
    EXPECT_NE(content(path("page.html")).find("\"fileVertices\":" + count), std::string::npos);
  }
}

TEST_F(Studio, writes_nothing_where_it_cannot_be_used)
{
  if (!is_built_in()) return;
  EXPECT_TRUE(fails(run("studio a.off -o page.ply"), 5, "wanted .html"));
  EXPECT_TRUE(fails(run("studio missing.off -o page.html"), 3, "missing.off"));
  write("open.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 5\n1 0 5\n0 1 5\n3 0 1 2\n3 3 4 5\n");
  EXPECT_TRUE(fails(run("studio open.off -o page.html"), 4, "component"));
  EXPECT_FALSE(has("page.html"));
}

TEST(Studio_page, begins_with_the_bound_of_the_program)
{
  EXPECT_NE(conformal::studio_page({}, {}).find("\"bound\":2.0,"), std::string::npos);
}

TEST(Studio_surface, finds_what_the_library_finds)
{
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(3);
  const Eigen::VectorXd rho = bump(mesh, 2);
  const auto potential =
      CGP::Curvature_potential::on_vertices(rho * (1 / conformal::User_frame(mesh).unit()));
  Studio_surface surface(mesh);
  surface.transform(rho, 0);
  EXPECT_EQ(surface.positions(), CGP::Spin_transformation(mesh).transform(potential).positions);
  CGP::Spin_transformation_options options;
  options.scales.bound = 1.2;
  surface.transform(rho, 1.2);
  const CGP::Spin_result bounded = CGP::Spin_transformation(mesh, options).transform(potential);
  EXPECT_EQ(surface.positions(), bounded.positions);
  EXPECT_TRUE(surface.outcome().verdict->is_verified());
}

TEST(Studio_surface, previews_what_it_will_find)
{
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(3);
  Studio_surface surface(mesh);
  const Eigen::VectorXd rho = bump(mesh, 2);
  surface.preview(rho / 2, 0, false);
  surface.preview(rho, 0, true);
  const CGP::Points preview = surface.positions();
  surface.transform(rho, 0);
  const double moved = (surface.positions() - mesh.positions()).norm();
  EXPECT_LT((surface.positions() - preview).norm(), .02 * moved);
}

// And near what is found on release.
TEST(Studio_surface, previews_within_the_bound_on_sizes)
{
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(3);
  Studio_surface surface(mesh);
  const Eigen::VectorXd rho = bump(mesh, 6);
  const double bound = 1.5;
  for (const double share : {.3, .6, 1.}) {
    surface.preview(share * rho, bound, share > .3);
    const auto scales =
        nlohmann::json::parse(to_json(surface.outcome())).at("result").at("scale_control");
    EXPECT_LT(scales.at("high").get<double>(), 1.01 * bound) << share;
    EXPECT_GT(scales.at("low").get<double>(), 1 / (1.01 * bound)) << share;
  }
  const CGP::Points preview = surface.positions();
  surface.transform(rho, bound);
  const double moved = (surface.positions() - mesh.positions()).norm();
  EXPECT_LT((surface.positions() - preview).norm(), .05 * moved);
}

TEST(Studio_surface, refuses_in_words_what_is_not_conformal)
{
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(2);
  Studio_surface surface(mesh);
  surface.transform(bump(mesh, 60), 0);
  EXPECT_FALSE(surface.outcome().verdict->is_verified());
  EXPECT_NE(surface.outcome().verdict->fault.find("; try: "), std::string::npos);
}

TEST(Studio_surface, flows_step_by_step)
{
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(2);
  Studio_surface surface(mesh);
  surface.flow();
  const CGP::Points first = surface.positions();
  CGP::Flow_options options;
  options.max_steps = 1;
  CGP::Conformal_willmore_flow flow(mesh, options);
  EXPECT_TRUE(flow.run());
  EXPECT_EQ(first, flow.mesh().positions());
  surface.flow();
  EXPECT_NE(first, surface.positions());
  EXPECT_TRUE(surface.outcome().verdict->is_verified());
}

TEST(Studio_surface, stays_verified_where_the_flow_has_settled)
{
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(2);
  Studio_surface surface(mesh);
  const auto result = [&] {
    return nlohmann::json::parse(to_json(surface.outcome())).at("result");
  };
  surface.flow();
  const double initial = result().at("energy").at("initial");
  EXPECT_FALSE(result().at("converged"));
  for (int step = 1; step < 30 && !result().at("converged"); ++step) surface.flow();
  for (int again = 0; again < 2; ++again) {
    EXPECT_TRUE(result().at("converged"));
    EXPECT_TRUE(surface.outcome().verdict->is_verified()) << surface.outcome().verdict->fault;
    EXPECT_EQ(result().at("energy").at("initial"), initial);
    EXPECT_NEAR(result().at("energy").at("final").get<double>(), 16 * std::atan(1), .3);
    surface.flow();
  }
}

TEST(Built_in_shapes, are_surfaces_of_each_kind)
{
  const auto shapes = conformal::built_in_shapes();
  ASSERT_EQ(shapes.size(), 4u);
  for (const conformal::Studio_shape& shape : shapes) {
    EXPECT_NO_THROW(CGP::require_surface(shape.mesh, shape.name));
    EXPECT_GT(shape.mesh.size_of_faces(), 4000) << shape.name;
    Studio_surface surface(shape.mesh);
    surface.transform(bump(shape.mesh, .5), 0);
    EXPECT_TRUE(surface.outcome().verdict->is_verified())
        << shape.name << ": " << surface.outcome().verdict->fault;
  }
  EXPECT_EQ(CGP::topology(shapes[2].mesh).genus, 1);
  EXPECT_FALSE(CGP::topology(shapes[3].mesh).is_closed());
}

}  // namespace cgp_test::studio_tests
