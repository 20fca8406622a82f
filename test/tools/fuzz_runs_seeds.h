// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/glb/write_glb.h"
#include "conformal/io/obj/write_obj.h"
#include "conformal/io/off/write_off.h"
#include "conformal/io/ply/write_ply.h"
#include "conformal/io/vtk/write_vtk.h"
#include "conformal/io/vtk/write_vtp.h"
#include "fuzz_json_mutations.h"
#include "fuzz_readers_seeds.h"
#include "support/meshes.h"

// Surfaces of 24 to 100 vertices on which every command has something to do, as files.

namespace fuzz {

using Conformal_geometry_processing::Mesh_view;

inline Mesh_view bent_grid()
{
  return cgp_test::mapped(cgp_test::grid(5, 5), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), 0.3 * std::sin(3 * p.x()) * p.y());
  });
}

/// closed, with a boundary of one loop and of two, with a handle and with two, in two components
inline std::vector<Mesh_view> seed_surfaces()
{
  return {cgp_test::bumpy_sphere(1),
          bent_grid(),
          cgp_test::cylinder(1, 2, 8, 3),
          cgp_test::torus(2, 0.7, 10, 6),
          cgp_test::double_torus(),
          cgp_test::disjoint_union(cgp_test::icosahedron(), cgp_test::icosahedron(),
                                   Eigen::Vector3d(3, 0, 0))};
}

inline conformal::Surface_file file_of(const Mesh_view& mesh)
{
  conformal::Surface_file file;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    file.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto& corners : mesh.corners()) {
    const std::array<std::int64_t, 3> face = {corners[0], corners[1], corners[2]};
    conformal::append_face(file.polygons, face.data(), face.data() + 3);
  }
  file.vertices.size = file.points.size();
  file.faces.size = file.polygons.size();
  return file;
}

// Points as short as they can be, so that corners meet again.
inline std::string stl_of(const Mesh_view& mesh)
{
  std::string text(80, ' ');
  append_bytes(text, static_cast<std::uint32_t>(mesh.size_of_faces()));
  for (const auto& corners : mesh.corners()) {
    for (int i = 0; i < 3; ++i) append_bytes(text, 0.f);
    for (const int v : corners)
      for (Eigen::Index i = 0; i < 3; ++i)
        append_bytes(text, static_cast<float>(mesh.position(v)[i]));
    append_bytes(text, std::uint16_t{0});
  }
  return text;
}

/// the surface in the format of this extension; PLY is text or binary by turns
inline std::string seed_file(const Mesh_view& mesh, const std::string& extension, bool is_text)
{
  std::vector<std::string> notes;
  if (extension == ".stl") return stl_of(mesh);
  const conformal::Surface_file file = file_of(mesh);
  if (extension == ".off") return conformal::encode_off(file, notes);
  if (extension == ".obj") return conformal::encode_obj(file, notes);
  if (extension == ".vtk") return conformal::encode_vtk(file, notes);
  if (extension == ".vtp") return conformal::encode_vtp(file, notes);
  if (extension == ".glb") return conformal::encode_glb(file, "", notes);
  if (extension == ".gltf") return gltf_of(conformal::encode_glb(file, "", notes));
  const auto encoding =
      is_text ? conformal::Ply_encoding::ascii : conformal::Ply_encoding::little_endian;
  return conformal::encode_ply(file, {encoding}, notes);
}

}  // namespace fuzz
