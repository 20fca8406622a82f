// Tests examples/conformal/io/read_gray_image.cpp examples/conformal/io/picture/Picture.cpp
// Tests examples/conformal/io/picture/read_png.cpp examples/conformal/io/picture/read_jpeg.cpp
// Tests examples/conformal/io/picture/read_pnm.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/read_gray_image.h"

#include "program/io/encoded_pictures.h"
#include "program/io/io_support.h"

namespace cgp_test::read_gray_image_tests {

using namespace io_test;

Eigen::ArrayXXd gray(const std::string& bytes)
{
  return conformal::parse_gray_image(bytes, "picture").pixels();
}

std::string refusal(const std::string& bytes)
{
  return message_of([&] { gray(bytes); });
}

TEST(Pictures, are_the_same_in_every_encoding_and_depth)
{
  const Eigen::ArrayXXd wanted = blocks().cast<double>() / 15;
  for (const auto& [name, bytes] : encoded_blocks()) {
    const Eigen::ArrayXXd read = gray(bytes);
    ASSERT_EQ(read.rows(), wanted.rows()) << name;
    ASSERT_EQ(read.cols(), wanted.cols()) << name;
    EXPECT_TRUE((read == wanted).all()) << name << ": " << (read - wanted).abs().maxCoeff();
  }
}

TEST(Pictures, are_read_from_files)
{
  const Folder folder;
  put_file(folder / "a.pgm", encoded_blocks()[0].second);
  EXPECT_EQ(conformal::read_gray_image(folder / "a.pgm").width(), 32);
}

TEST(Pictures, have_the_luminance_of_their_colours)
{
  const std::string red("P6 1 1 255\n\xff\0\0", 14), green("P6 1 1 255\n\0\xff\0", 14);
  EXPECT_DOUBLE_EQ(gray(red)(0, 0), 0.299);
  EXPECT_DOUBLE_EQ(gray(green)(0, 0), 0.587);
}

TEST(Pictures, may_have_comments_where_netpbm_has_them)
{
  const Eigen::ArrayXXd read = gray("P2# plain\n2 # width\n1\n# largest\n100 25 50");
  EXPECT_EQ(read(0, 0), 0.25);
  EXPECT_EQ(read(0, 1), 0.5);
}

TEST(Pictures, that_end_early_are_refused)
{
  for (const auto& [name, bytes] : encoded_blocks())
    for (const std::size_t left : {bytes.size() * 9 / 10, bytes.size() / 2, std::size_t{12}})
      EXPECT_NE(refusal(bytes.substr(0, left)), "no error") << name << ' ' << left;
}

TEST(Pictures, that_are_damaged_are_read_or_refused)
{
  for (const auto& [name, bytes] : encoded_blocks())
    for (std::size_t i = 0; i < 100; ++i) {
      std::string damaged = bytes;
      damaged[(i * 7919) % bytes.size()] = static_cast<char>(i * 37);
      EXPECT_NE(refusal(damaged), "") << name;
    }
}

TEST(Pictures, that_claim_more_than_they_have_are_refused_before_there_is_memory_for_them)
{
  EXPECT_NE(refusal("P5 32768 32768 255\nabc").find("the file ends"), std::string::npos);
  EXPECT_NE(refusal("P5 1000000000 1000000000 65535\nabc").find("the file ends"),
            std::string::npos);
  EXPECT_NE(refusal("P3 20000 20000 255\n1 2 3").find("the file ends"), std::string::npos);
  EXPECT_NE(refusal(empty_png(30000, 30000)).find("wanted at most 67108864"), std::string::npos);
  EXPECT_NE(refusal(empty_png(100000, 1)).find("wanted 1 to 32768"), std::string::npos);
}

TEST(Pictures, with_samples_above_white_are_refused)
{
  EXPECT_NE(refusal("P5 2 1 15\n\x01\x7f").find("a sample is 127"), std::string::npos);
  EXPECT_NE(refusal("P2 2 1 15 1 16").find("a sample is 16"), std::string::npos);
  EXPECT_NE(refusal("P5 2 1 0\n11").find("the largest value is 0"), std::string::npos);
  EXPECT_NE(refusal("P5 2 1 65536\n1111").find("the largest value is 65536"), std::string::npos);
}

}  // namespace cgp_test::read_gray_image_tests
