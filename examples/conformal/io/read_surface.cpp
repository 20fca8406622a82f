// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_surface.h"

#include "detect_format.h"

#include "conformal/io/file/read_bytes.h"
#include "conformal/io/glb/read_glb.h"
#include "conformal/io/obj/read_obj.h"
#include "conformal/io/off/read_off.h"
#include "conformal/io/ply/read_ply.h"
#include "conformal/io/stl/read_stl.h"
#include "conformal/io/vtk/read_vtk.h"
#include "conformal/io/vtk/read_vtp.h"

namespace conformal {

Surface_file parse_surface(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  switch (detect_format(bytes, path)) {
    case File_format::off:
      return parse_off(bytes, path, bad_faces);
    case File_format::obj:
      return parse_obj(bytes, path, bad_faces);
    case File_format::ply:
      return parse_ply(bytes, path, bad_faces);
    case File_format::glb:
    case File_format::gltf:
      return parse_glb(bytes, path, bad_faces);
    case File_format::vtk:
      return parse_vtk(bytes, path, bad_faces);
    case File_format::vtp:
      return parse_vtp(bytes, path, bad_faces);
    default:
      return parse_stl(bytes, path, bad_faces);
  }
}

Surface_file read_surface(const std::string& path, Bad_faces bad_faces)
{
  return parse_surface(read_bytes(path), path, bad_faces);
}

}  // namespace conformal
