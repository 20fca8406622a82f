// Tests examples/conformal/studio/studio_frame.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/studio/studio_frame.h"

#include "program/support.h"
#include "support/spheres.h"

#include "conformal/studio/studio_page_text.h"

#include <Conformal_geometry_processing/version.h>

#include <filesystem>
#include <string>

namespace cgp_test::studio_frame_tests {

using namespace program_test;

class Studio_frame : public Program {
 protected:
  Studio_frame() { write("a.off", off(cgp_test::bumpy_sphere(2))); }

  /// a page of a version, of which only the frame matters
  static std::string page_of(const std::string& version)
  {
    return "HEAD<script type=\"application/json\" id=\"studio\">{\"version\":\"" + version +
           "\"}</script>\n<script id=\"positions-0\">OLD</script>\n\n<script type=\"text/plain\" "
           "id=\"three\">TAIL";
  }

  bool has_frame_of_page(const std::string& page)
  {
    return page.rfind("HEAD<script", 0) == 0 && page.find("OLD") == std::string::npos &&
           page.find("\"file\":\"a.off\"") != std::string::npos &&
           page.find("id=\"squares-0\"") != std::string::npos &&
           page.substr(page.size() - 4) == "TAIL";
  }
};

TEST_F(Studio_frame, takes_the_scripts_of_a_page_that_is_given)
{
  write("old.html", page_of(CONFORMAL_GEOMETRY_PROCESSING_VERSION));
  const Program_run r = run("studio a.off -o page.html --advanced page=old.html");
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(r.err.find("version"), std::string::npos);
  EXPECT_TRUE(has_frame_of_page(content(path("page.html"))));
  EXPECT_EQ(run("studio a.off -o again.html --advanced page=page.html").code, 0);
  EXPECT_EQ(content(path("again.html")), content(path("page.html")));
}

TEST_F(Studio_frame, tells_that_a_page_is_of_another_version)
{
  write("old.html", page_of("0.0.1"));
  const Program_run r = run("studio a.off -o page.html --advanced page=old.html");
  EXPECT_EQ(r.code, 0);
  EXPECT_NE(r.err.find("version 0.0.1"), std::string::npos) << r.err;
}

TEST_F(Studio_frame, refuses_a_page_that_is_none)
{
  const std::string page = page_of("1.0.0");
  const std::string wrong[] = {"<html></html>", page.substr(0, 60),
                               page.substr(0, page.size() - 30), page_of("1.0.0\",,\"")};
  for (const std::string& other : wrong) {
    write("old.html", other);
    EXPECT_TRUE(fails(run("studio a.off -o page.html --advanced page=old.html"), 3,
                      "old.html: is not a page of the studio"))
        << other;
  }
  EXPECT_TRUE(fails(run("studio a.off -o page.html --advanced page=none.html"), 3, "none.html"));
  EXPECT_FALSE(has("page.html"));
}

TEST_F(Studio_frame, finds_the_page_that_is_installed)
{
  const std::filesystem::path installed = conformal::installed_studio_page();
  EXPECT_EQ(installed.filename(), "studio.html");
  if (conformal::studio_page_begin[0] != '\0' || std::filesystem::exists(installed)) return;
  std::filesystem::create_directories(installed.parent_path());
  write(installed.string(), page_of(CONFORMAL_GEOMETRY_PROCESSING_VERSION));
  const Program_run r = run("studio a.off -o page.html");
  std::filesystem::remove(installed);
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(has_frame_of_page(content(path("page.html"))));
}

}  // namespace cgp_test::studio_frame_tests
