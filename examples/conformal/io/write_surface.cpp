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
    throw Write_error(path, "has no known extension, wanted .ply, .off, .obj, .glb or .stl");
  return *format;
}

std::vector<std::string> write_surface(const std::string& path, const Surface_file& file,
                                       const Ply_style& style)
{
  std::vector<std::string> notes = file.notes;
  Temporary_file written(path);
  written.write(encoded(path, file, style, notes));
  if (const auto bytes = written.read_back())
    require_written(path, file, *bytes, notes, style.coordinates);
  written.commit();
  if (written.changes_owner()) notes.push_back(path + " has another owner than the file before");
  return notes;
}

}  // namespace conformal
