// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "keyed_options.h"
#include "option_groups.h"

#include "conformal/io/file/Temporary_file.h"
#include "conformal/report/page_blocks.h"
#include "conformal/studio/built_in_shapes.h"
#include "conformal/studio/studio_page.h"
#include "conformal/transform/suitable_surface.h"

#include <Conformal_geometry_processing/version.h>

namespace conformal {
namespace {

const char* const studio_about =
    "Writes a page on which one paints the change of mean curvature, rho, onto a surface, which\n"
    "follows: one HTML file that opens in a browser without a network. What is painted is "
    "computed\n"
    "there as `conformal spin --rho-file` would, and can be saved for it.\n"
    "Without an input the page has four shapes to try. Files can be dropped on it.\n"
    "Example: conformal studio bear.off -o bear.html";

struct Studio_options {
  std::string input;
  std::string page;  // whose scripts the new one has
};

void add_options(CLI::App& command, Studio_options& studio, Common_options& common)
{
  command.add_option("input", studio.input, "mesh file, - for standard input");
  add_repair(command, common);
  add_output(command, common, "the page")->required();
  advanced(command).add_option("--page", studio.page,
                               "a page of the studio from which the scripts are taken (default: "
                               "those of this program, or of the page that is installed with it)");
}

Files files(const Studio_options& studio)
{
  return {{"the input", studio.input}, {"page", studio.page}};
}

void studio(const Studio_options& options, Session& session)
{
  const Studio_frame frame = studio_frame(options.page);
  if (frame.version != CONFORMAL_GEOMETRY_PROCESSING_VERSION)
    session.note("the scripts of the page are of version " + frame.version +
                 ", this program is of " CONFORMAL_GEOMETRY_PROCESSING_VERSION);
  require_page_name(session.options().output);
  std::vector<Studio_shape> shapes;
  if (options.input.empty())
    shapes = built_in_shapes();
  else
    shapes.push_back(shape_of(read_suitable_surface(options.input, session)));
  write_file(session.options().output, studio_page(shapes, frame));
  session.end_stage("write");
}

}  // namespace

Command studio_command()
{
  return make_command<Studio_options>("studio", studio_about, add_options, files, studio);
}

}  // namespace conformal
