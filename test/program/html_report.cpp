// Tests examples/conformal/report/html_report.cpp examples/conformal/report/Report_files.cpp
// Tests examples/conformal/report/conformal_charts.cpp examples/conformal/report/keep_exhibit.cpp
// Tests examples/conformal/report/face_regions.cpp examples/conformal/report/mesh_piece.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/report/html_report.h"

#include "program/support.h"
#include "support/spheres.h"
#include "support/tori.h"

#include "conformal/io/file/base64.h"
#include "conformal/report/conformal_charts.h"
#include "conformal/report/face_regions.h"
#include "conformal/report/mesh_piece.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <string>

namespace cgp_test::html_report_tests {

using namespace program_test;
using namespace std::string_literals;
namespace CGP = Conformal_geometry_processing;

class Html_report : public Program {
 protected:
  Html_report() { write("a.off", off(cgp_test::bumpy_sphere(2))); }

  bool is_built_in() const { return conformal::why_no_html_reports().empty(); }

  /// the content of a block of a page
  static std::string block(const std::string& page, const std::string& name)
  {
    const std::string head = "id=\"" + name + "\">";
    const std::size_t begin = page.find(head) + head.size();
    return page.substr(begin, page.find("</script>", begin) - begin);
  }
};

const std::string spin = " --rho-expression x -o b.ply ";

TEST_F(Html_report, is_written_or_refused_with_the_reason)
{
  const Program_run r = run("spin -q a.off" + spin + "--html r.html");
  if (is_built_in()) {
    EXPECT_EQ(r.code, 0) << r.err;
    const std::string policy =
        "Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-";
    EXPECT_NE(content(path("r.html")).find(policy), std::string::npos);
  } else {
    EXPECT_TRUE(fails(r, 2, conformal::why_no_html_reports()));
    EXPECT_TRUE(fails(r, 2, " -DCGP_HTML_REPORT=ON && cmake --build "));
    EXPECT_FALSE(has("b.ply"));
  }
  EXPECT_EQ(temporary_files(), 0u);
}

TEST_F(Html_report, holds_the_report_and_an_array_of_each_kind)
{
  const int vertices = cgp_test::bumpy_sphere(2).size_of_vertices(), faces = 2 * vertices - 4;
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(2);
  const conformal::Exhibit exhibit{mesh, mesh.positions(),
                                   conformal::Corner_places(std::size_t(3 * faces)), "here"};
  const std::string page = conformal::html_report(exhibit, "{\"file\": \"a</script><!--\"}");
  const auto size = [&](const char* name) { return static_cast<int>(block(page, name).size()); };
  const auto in_base64 = [](int bytes) { return (bytes + 2) / 3 * 4; };
  EXPECT_EQ(nlohmann::json::parse(block(page, "report"))["file"], "a</script><!--");
  EXPECT_EQ(size("before"), in_base64(12 * vertices));
  EXPECT_EQ(size("after"), in_base64(12 * vertices));
  EXPECT_EQ(size("faces"), in_base64(12 * faces));
  EXPECT_EQ(size("quality"), in_base64(4 * faces));
  EXPECT_EQ(size("squares"), in_base64(24 * faces));
  // Q is 1 where nothing moves: a float of 1 is 00 00 80 3f.
  EXPECT_EQ(block(page, "quality").substr(0, 8), conformal::base64("\x00\x00\x80\x3f\x00\x00"s));
}

TEST_F(Html_report, does_not_appear_when_the_command_fails)
{
  if (!is_built_in()) return;
  const std::string limits = "--limit quasi_conformal=1.0000001 --html r.html";
  EXPECT_TRUE(fails(run("spin a.off" + spin + limits), 1, "quasi-conformal"));
  EXPECT_TRUE(fails(run("flow a.off --steps 1 -o missing/b.ply --html r.html"), 5, "missing"));
  EXPECT_FALSE(has("r.html"));
  EXPECT_EQ(temporary_files(), 0u);
}

TEST_F(Html_report, keeps_the_old_one_when_the_command_fails)
{
  if (!is_built_in()) return;
  write("r.html", "old");
  EXPECT_TRUE(fails(run("compare a.off a.off -o b.xyz --html r.html"), 5, "extension"));
  EXPECT_EQ(content(path("r.html")), "old");
}

TEST_F(Html_report, has_a_name_of_its_own)
{
  const std::string with_json = "--json r.html --html r.html";
  EXPECT_TRUE(fails(run("spin a.off" + spin + with_json), 2, "the same file"));
  EXPECT_TRUE(fails(run("spin a.off --rho-expression x -o b.ply --html b.ply"), 2, "same file"));
  EXPECT_TRUE(fails(run("spin a.off" + spin + "--json ./b.ply"), 2, "the same file"));
  if (is_built_in()) {
    EXPECT_TRUE(fails(run("spin a.off" + spin + "--html b.off"), 5, "wanted .html"));
  }
  EXPECT_FALSE(has("b.ply"));
}

TEST_F(Html_report, is_refused_where_its_folder_is_missing_before_anything_is_written)
{
  if (!is_built_in()) return;
  EXPECT_TRUE(fails(run("spin a.off" + spin + "--html missing/r.html"), 5, "missing/r.html"));
  EXPECT_FALSE(has("b.ply"));
}

TEST(Base64, has_the_texts_of_the_standard)
{
  EXPECT_EQ(conformal::base64(""), "");
  EXPECT_EQ(conformal::base64("f"), "Zg==");
  EXPECT_EQ(conformal::base64("fo"), "Zm8=");
  EXPECT_EQ(conformal::base64("foo"), "Zm9v");
  EXPECT_EQ(conformal::base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(conformal::base64("\xff\xfe\xfd"), "//79");
}

TEST(Face_regions, are_as_many_as_wanted_and_connected)
{
  const CGP::Mesh_view mesh = cgp_test::bumpy_sphere(3);
  const std::vector<int> region = conformal::face_regions(mesh, 7);
  EXPECT_EQ(std::set<int>(region.begin(), region.end()), (std::set<int>{0, 1, 2, 3, 4, 5, 6}));
  // Flood each region from its first face.
  std::vector<bool> reached(region.size(), false);
  for (int r = 0; r < 7; ++r) {
    std::vector<int> stack{
        static_cast<int>(std::find(region.begin(), region.end(), r) - region.begin())};
    reached[static_cast<std::size_t>(stack.back())] = true;
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int h = 3 * f; h < 3 * f + 3; ++h) {
        const auto g = static_cast<std::size_t>(mesh.twin(h) / 3);
        if (region[g] != r || reached[g]) continue;
        reached[g] = true;
        stack.push_back(static_cast<int>(g));
      }
    }
  }
  EXPECT_EQ(std::count(reached.begin(), reached.end(), false), 0);
}

TEST(Face_regions, do_not_leap_from_one_component_to_another)
{
  const CGP::Mesh_view two(CGP::Points::Random(3, 6), {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(conformal::face_regions(two, 1), (std::vector<int>{0, 1}));
}

TEST(Mesh_piece, parts_faces_that_meet_in_nothing_but_a_vertex)
{
  // Two pairs of triangles about vertex 0, and a fifth that is of another region.
  const CGP::Mesh_view mesh(CGP::Points::Random(3, 7),
                            {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}});
  const std::vector<int> region = {0, 0, 1, 0, 0};
  const conformal::Mesh_piece piece = conformal::mesh_piece(mesh, {0, 1, 3, 4}, region);
  EXPECT_EQ(piece.mesh.size_of_vertices(), 8);
  EXPECT_NE(piece.mesh.corners(1)[0], piece.mesh.corners(2)[0]);
  EXPECT_EQ(piece.mesh.corners(0)[0], piece.mesh.corners(1)[0]);
  EXPECT_EQ(piece.mesh.corners(0)[2], piece.mesh.corners(1)[1]);
  for (std::size_t k = 0; k < piece.faces.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(piece.mesh.position(piece.mesh.corners()[k][i]),
                mesh.position(mesh.corners(piece.faces[k])[i]));
}

/// the stretch along the first axis by that along the second, of the map of a triangle to places
double quasi_conformal_error(const CGP::Mesh_view& mesh, int f, const conformal::Corner_places& uv)
{
  const auto& c = mesh.corners(f);
  const auto place = [&](std::size_t i) {
    const auto& p = uv[static_cast<std::size_t>(3 * f) + i];
    return Eigen::Vector2d(p[0], p[1]);
  };
  Eigen::Matrix<double, 3, 2> from;
  from << mesh.position(c[1]) - mesh.position(c[0]), mesh.position(c[2]) - mesh.position(c[0]);
  Eigen::Matrix2d to;
  to << place(1) - place(0), place(2) - place(0);
  if (to.determinant() <= 0) return HUGE_VAL;
  const Eigen::Vector2d s = (from * to.inverse()).jacobiSvd().singularValues();
  return s[0] / s[1];
}

void expect_squares(const CGP::Mesh_view& mesh)
{
  const conformal::Corner_places uv = conformal::conformal_charts(mesh);
  ASSERT_EQ(uv.size(), 3 * static_cast<std::size_t>(mesh.size_of_faces()));
  std::vector<double> Q;
  for (int f = 0; f < mesh.size_of_faces(); ++f) Q.push_back(quasi_conformal_error(mesh, f, uv));
  std::sort(Q.begin(), Q.end());
  EXPECT_LT(Q[Q.size() / 2], 1.1);
  EXPECT_LT(Q[Q.size() * 9 / 10], 1.25);
}

TEST(Conformal_charts, keep_squares_square_on_a_closed_surface)
{
  expect_squares(cgp_test::bumpy_sphere(4));
}

TEST(Conformal_charts, keep_squares_square_on_a_surface_with_a_handle)
{
  expect_squares(cgp_test::torus(1, 0.4, 48, 24));
}

TEST(Conformal_charts, see_a_piece_that_has_no_map_to_the_plane_along_its_normal)
{
  // A small closed surface beside a large one is a piece as a whole, for its neighbours are far.
  CGP::Mesh_view large = cgp_test::bumpy_sphere(2);
  const int n = large.size_of_vertices();
  CGP::Points points(3, n + 3);
  points << large.positions(), 1e-3 * CGP::Points::Identity(3, 3);
  CGP::Mesh_view::Corners corners = large.corners();
  corners.push_back({n, n + 1, n + 2});
  corners.push_back({n, n + 2, n + 1});
  const conformal::Corner_places uv = conformal::conformal_charts({points, corners});
  const std::size_t first = 3 * static_cast<std::size_t>(large.size_of_faces());
  for (std::size_t i = 0; i < 3; ++i) {
    const auto a = uv[first + i], b = uv[first + (i + 1) % 3];
    EXPECT_NEAR(std::hypot(a[0] - b[0], a[1] - b[1]), 0, 1.5e-3);
  }
}

TEST(Conformal_charts, are_there_for_a_single_triangle)
{
  const CGP::Mesh_view mesh(CGP::Points::Identity(3, 3), {{0, 1, 2}});
  EXPECT_LT(quasi_conformal_error(mesh, 0, conformal::conformal_charts(mesh)), 1 + 1e-9);
}

}  // namespace cgp_test::html_report_tests
