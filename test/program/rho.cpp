// Tests examples/conformal/input/rho.cpp examples/conformal/input/rho_from_values.cpp
// Tests examples/conformal/input/rho_from_image.cpp examples/conformal/input/Expression.cpp
// Tests examples/conformal/input/filter_rho.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/input/rho.h"

#include "program/support.h"
#include "support/meshes.h"
#include "support/spheres.h"

#include "conformal/input/Expression.h"
#include "conformal/io/read_gray_image.h"
#include "conformal/io/read_surface.h"
#include "conformal/process/Failure.h"

#include <cmath>

namespace cgp_test::rho_tests {

using namespace program_test;
using namespace conformal;

using Rho = Program;

double value(const std::string& formula, const Eigen::Vector3d& p = {1, 2, 3})
{
  return Expression(formula)(p, {0.25, 0.5, 0.75});
}

TEST(Expression, knows_points_normals_constants_and_bumps)
{
  EXPECT_DOUBLE_EQ(value("x+10*y+100*z"), 321);
  EXPECT_DOUBLE_EQ(value("nx+ny+nz"), 1.5);
  EXPECT_NEAR(value("cos(pi)+ln(e)"), 0, 1e-15);
  EXPECT_DOUBLE_EQ(value("gauss(1,2)"), std::exp(-0.125));
  EXPECT_DOUBLE_EQ(value("bump(0,3)"), 1);
  EXPECT_DOUBLE_EQ(value("bump(3,3)"), 0);
}

TEST(Expression, that_is_no_formula_names_the_place)
{
  for (const std::string wrong : {"x+", "sin(x", "x+foo", "", "x,y", "2x)", "x=1", "y+(x=2)"}) try {
      value(wrong);
      FAIL() << wrong;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit_code::usage);
    }
  try {
    value("x+foo");
  } catch (const Failure& failure) {
    EXPECT_NE(std::string(failure.what()).find("\"foo\" found, at place 3"), std::string::npos)
        << failure.what();
  }
}

TEST(Expression, may_compare_but_not_assign)
{
  for (const std::string comparison : {"x<=1", "x>=1", "x==1", "x!=2"})
    EXPECT_EQ(value(comparison), 1) << comparison;
  for (const std::string assignment : {"z=4", "x<=(y=2)"}) EXPECT_THROW(value(assignment), Failure);
}

TEST_F(Rho, of_a_formula_that_is_too_long_or_empty_is_a_usage_error)
{
  std::string sum = "x";
  while (sum.size() <= 20000) sum += "+x";
  write("a.off", off(cgp_test::disk(3)));
  const std::string out = " a.off -o b.ply ";
  EXPECT_TRUE(fails(run("spin" + out + "--rho-expression " + sum), 2, "is too long"));
  EXPECT_TRUE(fails(run("boundary" + out + "--binormal-tilt " + sum), 2, "is too long"));
  for (const std::string nothing : {"''", "' '"}) {
    EXPECT_TRUE(fails(run("spin" + out + "--rho-expression " + nothing), 2, "an empty formula"));
    EXPECT_TRUE(fails(run("boundary" + out + "--binormal-tilt " + nothing), 2, "an empty formula"));
    EXPECT_TRUE(fails(run("boundary" + out + "--tangent-rotation " + nothing), 2, "empty formula"));
    EXPECT_TRUE(fails(run("fit a.off" + out + "--blend 1 --scale-expression " + nothing), 2,
                      "an empty formula"));
  }
  for (const std::string option : {"--rho-file", "--rho-property", "--paint"})
    EXPECT_TRUE(fails(run("spin" + out + option + " ''"), 2, option + ": wanted a name"));
}

TEST_F(Rho, of_an_expression_lives_in_the_frame_of_diagonal_2)
{
  const auto mesh = cgp_test::scaled(cgp_test::icosahedron(), 40);
  const Surface_input input = prepare(parse_surface(off(mesh), "a.off"));
  const User_frame frame(input.mesh);
  Rho_options options;
  options.expression = "x";
  options.amplitude = 3;
  const auto rho = read_rho(input, options);
  EXPECT_NEAR(rho.values[8], 3 * mesh.position(8).x() / frame.unit(), 1e-12);
  options.on_faces = true;
  EXPECT_EQ(read_rho(input, options).values.size(), 20);
}

TEST_F(Rho, that_is_not_finite_names_the_vertex)
{
  write("a.off", off(cgp_test::icosahedron()));
  EXPECT_TRUE(fails(run("spin -q a.off -o b.ply --rho-expression '1/(x-x)'"), 4,
                    "at 12 vertices (first: vertex 0)"));
}

TEST_F(Rho, of_a_file_has_a_number_per_vertex_or_face)
{
  write("a.off", off(cgp_test::icosahedron()));
  const std::string spin = "spin -q a.off -o b.ply --rho-file ";
  std::string twelve = "# a comment\n";
  for (int i = 0; i < 12; ++i) twelve += "0." + std::to_string(i % 10) + "\n";
  write("rho.txt", twelve);
  EXPECT_EQ(run(spin + "rho.txt").code, 0);
  EXPECT_TRUE(fails(run(spin + "rho.txt --on faces"), 4, "wanted one per vertex (12)"));
  write("rho.txt", twelve + "1\n");
  EXPECT_TRUE(fails(run(spin + "rho.txt"), 4, "has 13 numbers"));
  write("rho.txt", twelve + "one\n");
  EXPECT_TRUE(fails(run(spin + "rho.txt"), 3, "rho.txt:14: 'one' is not a number"));
  EXPECT_TRUE(fails(run(spin + "absent.txt"), 3, "absent.txt"));
  EXPECT_TRUE(fails(run(spin + "."), 3, "is a directory, wanted a file with numbers"));
  EXPECT_TRUE(fails(run("spin a.off -o b.ply --paint ."), 3, "is a directory, wanted a picture"));
}

TEST_F(Rho, of_a_property_comes_back_and_others_come_through)
{
  write("a.off", off(cgp_test::icosphere(1)));
  ASSERT_EQ(run("spin a.off -o b.ply --rho-expression 'x*y' --lambda mine").code, 0);
  EXPECT_EQ(run("spin b.ply -o c.ply --rho-property rho").code, 0);
  const auto b = read_surface(path("b.ply")), c = read_surface(path("c.ply"));
  EXPECT_EQ(find_property(b.vertices, "mine_x")->value(7),
            find_property(c.vertices, "mine_x")->value(7));
  EXPECT_EQ(find_property(b.vertices, "rho")->value(7), find_property(c.vertices, "rho")->value(7));
  EXPECT_TRUE(fails(run("spin -q b.ply -o c.ply --rho-property density"), 4,
                    "vertices have: quality, rho, mine_w"));
}

TEST_F(Rho, of_a_picture_by_each_projection)
{
  write("a.off", off(cgp_test::icosphere(1)));
  write("gray.pgm", std::string("P5 2 2 255\n") + '\0' + '\xff' + '\x80' + '\x40');
  for (const std::string projection : {"x", "y", "z", "sphere"})
    EXPECT_EQ(run("spin a.off -o b.ply --rho-image gray.pgm --projection " + projection).code, 0);
  EXPECT_TRUE(
      fails(run("spin -q a.off -o c.ply --rho-image gray.pgm"), 4, "no texture coordinates"));
  EXPECT_TRUE(fails(run("spin -q a.off -o c.ply --rho-image a.off"), 3, "as PNG, JPEG"));
}

TEST_F(Rho, of_a_picture_takes_the_mean_at_a_seam)
{
  write("gray.pgm", std::string("P5 2 1 255\n") + '\0' + '\xff');
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\n"
      "f 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 1/2 4/1 3/1\nf 2/1 3/1 4/1\n";
  const Surface_input input = prepare(parse_surface(text, "a.obj"));
  Rho_options options;
  options.image = path("gray.pgm");
  const auto rho = read_rho(input, options);
  EXPECT_NEAR(rho.values[0], 1. / 3 - 0.5, 1e-12);
  EXPECT_NEAR(rho.values[1], -0.5, 1e-12);
}

TEST_F(Rho, of_a_picture_on_faces_is_that_of_their_middles)
{
  write("gray.pgm", std::string("P5 2 1 255\n") + '\0' + '\xff');
  Rho_options options;
  options.image = path("gray.pgm");
  options.on_faces = true;
  const std::string seam =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0.6 1\n"
      "f 1/1 3/1 2/3\nf 1/1 2/3 4/3\nf 1/2 4/1 3/1\nf 2/1 3/1 4/1\n";
  const auto rho = read_rho(prepare(parse_surface(seam, "a.obj")), options);
  // The middles are at u = 0.2, 0.4, 1/3, 0; gray is linear from 0.25 to 0.75.
  EXPECT_LT((rho.values - Eigen::Vector4d(-0.5, -0.2, 1. / 6 - 0.5, -0.5)).norm(), 1e-12);
}

TEST_F(Rho, of_a_picture_by_a_projection_is_taken_at_the_middles_of_faces)
{
  std::string ramp = "P5 64 1 255\n";
  for (int i = 0; i < 64; ++i) ramp += static_cast<char>(4 * i);
  write("ramp.pgm", ramp);
  const Surface_input input = prepare(parse_surface(off(cgp_test::icosahedron()), "a.off"));
  Rho_options options;
  options.image = path("ramp.pgm");
  options.projection = Projection::y;
  const Eigen::VectorXd at_vertices = read_rho(input, options).values;
  options.on_faces = true;
  const Eigen::VectorXd at_faces = read_rho(input, options).values;
  ASSERT_EQ(at_faces.size(), 20);
  for (int f = 0; f < 20; ++f) {
    const auto& [a, b, c] = input.mesh.corners(f);
    const double mean = (at_vertices[a] + at_vertices[b] + at_vertices[c]) / 3;
    EXPECT_NEAR(at_faces[f], mean, 0.01);  // except for half a pixel at the border
  }
}

TEST_F(Rho, of_a_picture_is_refused_where_a_face_has_no_place_in_it)
{
  write("gray.pgm", std::string("P5 2 1 255\n") + '\0' + '\xff');
  write("a.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\n"
        "f 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 1/1 4/1 3/1\nf 2 3 4\n");
  EXPECT_TRUE(fails(run("spin -q a.obj -o b.ply --paint gray.pgm --on faces"), 4,
                    "not a finite number at 1 face (first: face 3"));
}

/// A striped picture and its filtered versions
class Filtered_picture : public Program {
 protected:
  Filtered_picture()
  {
    std::string pixels = "P5 16 16 255\n";
    for (int i = 0; i < 256; ++i) pixels += i / 4 % 2 == 0 ? '\x30' : '\xb0';
    write("gray.pgm", pixels);
    write("a.off", off(cgp_test::icosphere(2)));
    m_options.image = path("gray.pgm");
    m_options.projection = Projection::sphere;
  }

  Eigen::VectorXd rho(Filter_choice choice)
  {
    m_options.filter.choice = choice;
    return read_rho(prepare(read_surface(path("a.off"))), m_options).values;
  }

  /// low and high add up, the one is less, and the unsharp mask adds `amount` times the other
  void expect_bands(double amount)
  {
    m_options.filter.amount.reset();
    const Eigen::VectorXd all = rho(Filter_choice::none), low = rho(Filter_choice::low_pass);
    const Eigen::VectorXd high = rho(Filter_choice::high_pass);
    m_options.filter.amount = amount;
    const Eigen::VectorXd sharp = rho(Filter_choice::unsharp);
    EXPECT_LT((low + high - all).norm(), 1e-12 * all.norm());
    EXPECT_LT((all + amount * high - sharp).norm(), 1e-12 * sharp.norm());
    EXPECT_LT(low.norm(), 0.8 * all.norm());
  }

  Rho_options m_options;
};

TEST_F(Filtered_picture, has_bands_that_add_up_on_the_picture_and_on_the_surface)
{
  m_options.filter.radius = 2;
  expect_bands(1.5);
  m_options.filter.radius.reset();
  m_options.filter.on_image = false;
  m_options.filter.weight = 0.1;
  m_options.filter.order = 2;
  expect_bands(3);
}

TEST_F(Filtered_picture, is_painted_by_the_program)
{
  const std::string spin = "spin -q a.off -o b.ply --projection sphere --paint gray.pgm ";
  for (const std::string filter :
       {"low-pass --filter-radius 2", "high-pass", "unsharp",
        "unsharp --advanced filter-on=surface --advanced filter-amount=2"}) {
    const Program_run done = run(spin + "--filter " + filter);
    EXPECT_EQ(done.code, 0) << done.err;
  }
  EXPECT_EQ(run("spin -q a.off -o b.ply --rho-expression 'x*y' --filter low-pass").code, 0);
}

TEST_F(Filtered_picture, wants_options_that_go_together)
{
  const std::string begin = "spin -q a.off -o b.ply ";
  const std::string paint = begin + "--projection z --paint gray.pgm ";
  const std::string formula = begin + "--rho-expression x --filter low-pass ";
  EXPECT_TRUE(fails(run(paint + "--filter-radius 2"), 2, "--filter"));
  EXPECT_TRUE(fails(run(paint + "--filter blur"), 2, "low-pass"));
  EXPECT_TRUE(fails(run(paint + "--filter low-pass --filter-radius 0"), 2, "above 0"));
  EXPECT_TRUE(
      fails(run(paint + "--filter low-pass --advanced filter-amount=2"), 2, "unsharp only"));
  EXPECT_TRUE(fails(run(paint + "--filter low-pass --filter-weight 2"), 2, "--filter-radius"));
  EXPECT_TRUE(fails(run(formula + "--advanced filter-on=image"), 2, "wants a picture"));
  EXPECT_TRUE(fails(run(formula + "--filter-radius 2"), 2, "of pictures"));
  EXPECT_TRUE(fails(run(formula + "--on faces"), 2, "--on vertices"));
}

TEST_F(Rho, generalized_problem_wants_it_on_faces)
{
  write("a.off", off(cgp_test::icosphere(1)));
  const std::string spin =
      "spin -q a.off -o b.ply --rho-expression x --advanced problem=generalized";
  EXPECT_TRUE(fails(run(spin), 2, "--on faces"));
  EXPECT_EQ(run(spin + " --on faces").code, 0);
}

}  // namespace cgp_test::rho_tests
