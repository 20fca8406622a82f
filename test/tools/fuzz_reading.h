// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/csv/read_curve_rows.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/glb/read_glb.h"
#include "conformal/io/glb/write_glb.h"
#include "conformal/io/obj/read_obj.h"
#include "conformal/io/obj/write_obj.h"
#include "conformal/io/off/read_off.h"
#include "conformal/io/off/write_off.h"
#include "conformal/io/ply/read_ply.h"
#include "conformal/io/ply/write_ply.h"
#include "conformal/io/read_surface.h"
#include "conformal/io/stl/read_stl.h"
#include "conformal/io/svg/read_svg.h"
#include "conformal/io/vtk/read_vtk.h"
#include "conformal/io/vtk/read_vtp.h"
#include "conformal/io/vtk/write_vtk.h"
#include "conformal/io/vtk/write_vtp.h"
#include "fuzz_trials.h"

#include <cmath>

// One file through the readers and, if it is read, through the writers.

namespace fuzz {

// The guarantees of the readers.
inline void require_sound(const conformal::Surface_file& file)
{
  for (const auto& point : file.points)
    for (const double x : point) require(std::isfinite(x), "a coordinate is not finite");
  require(file.points.size() == file.vertices.size, "properties of other vertices");
  require(file.polygons.size() == file.faces.size, "properties of other faces");
  for (const int corner : file.polygons.corners)
    require(corner >= 0 && static_cast<std::size_t>(corner) < file.points.size(),
            "a corner is not a vertex");
}

// Every writer accepts the file, and PLY preserves it.
inline void require_writable(const conformal::Surface_file& file)
{
  std::vector<std::string> notes;
  conformal::encode_off(file, notes);
  conformal::encode_obj(file, notes);
  conformal::encode_vtk(file, notes);
  conformal::encode_vtp(file, notes);
  try {
    conformal::encode_glb(file, "", notes);
  } catch (const conformal::Write_error&) {  // coordinates exceed the range of float
  }
  for (const auto encoding :
       {conformal::Ply_encoding::ascii, conformal::Ply_encoding::big_endian}) {
    const std::string ply = conformal::encode_ply(file, {encoding}, notes);
    const conformal::Surface_file again = conformal::parse_ply(ply, "again.ply");
    require(again.points == file.points, "PLY brings back other points");
    require(again.polygons.corners == file.polygons.corners, "PLY brings back other faces");
    require(conformal::encode_ply(again, {encoding}, notes) == ply, "PLY is written otherwise");
  }
}

inline conformal::Surface_file parsed(const std::string& text, const std::string& extension,
                                      bool by_content)
{
  if (by_content) return conformal::parse_surface(text, "a" + extension);
  if (extension == ".off") return conformal::parse_off(text, "a.off");
  if (extension == ".obj") return conformal::parse_obj(text, "a.obj");
  if (extension == ".ply") return conformal::parse_ply(text, "a.ply");
  if (extension == ".glb" || extension == ".gltf") return conformal::parse_glb(text, "a.glb");
  if (extension == ".vtk") return conformal::parse_vtk(text, "a.vtk");
  if (extension == ".vtp") return conformal::parse_vtp(text, "a.vtp");
  return conformal::parse_stl(text, "a.stl");
}

inline void require_sound(const std::vector<conformal::Plane_curve>& curves)
{
  for (const conformal::Plane_curve& curve : curves)
    require(curve.points.allFinite(), "a point of a curve is not finite");
}

/// whether a file with curves is read, or else refused
inline bool are_curves_read(const std::string& text, const std::string& extension)
{
  std::vector<std::string> notes;
  try {
    require_sound(extension == ".svg" ? conformal::parse_svg(text, "a.svg", {}, notes)
                                      : conformal::parse_curve_rows(text, "a.csv"));
    return true;
  } catch (const conformal::Read_error&) {
    return false;
  }
}

/// whether the file is read, or else refused; its format is shown by the content or the extension
inline bool is_read(const std::string& text, const std::string& extension, bool by_content)
{
  try {
    const conformal::Surface_file file = parsed(text, extension, by_content);
    require_sound(file);
    require_writable(file);
    return true;
  } catch (const conformal::Read_error&) {
    return false;
  }
}

}  // namespace fuzz
