// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_surface.h"

#include "detect_format.h"
#include "require_written.h"

#include "conformal/io/file/Temporary_file.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/glb/write_glb.h"
#include "conformal/io/obj/write_obj.h"
#include "conformal/io/off/write_off.h"
#include "conformal/io/stl/write_stl.h"
#include "conformal/io/usd/write_usda.h"
#include "conformal/io/vtk/write_vtk.h"
#include "conformal/io/vtk/write_vtp.h"

namespace conformal {
namespace {

std::string encoded(const std::string& path, const Surface_file& file, const Ply_style& style,
                    std::vector<std::string>& notes)
{
  switch (output_format(path)) {
    case File_format::off:
      return encode_off(file, notes);
    case File_format::obj:
      return encode_obj(file, notes);
    case File_format::glb:
      return encode_glb(file, path, notes);
    case File_format::gltf:
      return encode_gltf(file, path, notes);
    case File_format::vtk:
      return encode_vtk(file, notes);
    case File_format::vtp:
      return encode_vtp(file, notes);
    case File_format::usda:
      return encode_usda(file, path, notes);
    case File_format::stl:
      return encode_stl(file, notes);
    default:
      return encode_ply(file, style, notes);
  }
}

}  // namespace

File_format output_format(const std::string& path)
{
  const auto format = format_of_extension(path);
  if (!format)
    throw Write_error(
        path,
        "has no known extension, wanted .ply, .off, .obj, .glb, .gltf, .stl, .vtk, .vtp or .usda");
  return *format;
}

std::vector<std::string> write_surface(const std::string& path, const Surface_file& file,
                                       const Ply_style& style)
{
  std::vector<std::string> notes = file.notes;
  Temporary_file written(path);
  written.write(encoded(path, file, style, notes));
  const auto bytes = output_format(path) == File_format::usda ? std::nullopt : written.read_back();
  if (bytes)  // of what is not read here, it cannot be told whether it is right
    require_written(path, file, *bytes, notes, style.coordinates);
  written.commit();
  if (written.changes_owner()) notes.push_back(path + " has another owner than the file before");
  return notes;
}

}  // namespace conformal
