// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"
#include "conformal/repair/repair.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// \brief A mesh file made ready for computation: polygons triangulated, faces oriented alike (and
/// outward, if the surface is closed), vertices without a face left out. The maps lead back.
struct Surface_input {
  Surface_file file;  ///< as read; where faces were against each other, some are turned around
  std::optional<Repair> repair;  ///< the preceding repair of the file, if requested

  CGP::Mesh_view mesh;
  std::vector<int> vertex_in_file;  ///< of each vertex of the mesh
  std::vector<int> face_in_file;    ///< of each triangle of the mesh

  int unreferenced = 0;            ///< vertices of the file without a face
  int coinciding = 0;              ///< vertices at the boundary that lie exactly on others there
  int triangulated = 0;            ///< polygons of the file with more than three corners
  int turned_faces = 0;            ///< faces whose orientation was repaired
  bool is_orientable = true;       ///< no face had to be left against its neighbour
  bool is_turned_outward = false;  ///< all faces of `mesh` are reversed against the file

  std::vector<std::string> notes;  ///< changes of the input, for the user
};

/// \param is_repaired whether the file is repaired first, see `repair()`
/// \throws Read_error; does not reject meshes for their properties
Surface_input read_surface_input(const std::string& path, bool is_repaired = false);

/// Likewise, of a file in memory; its name is for messages and for its extension.
Surface_input parse_surface_input(std::string_view bytes, const std::string& name,
                                  bool is_repaired = false);

/// Prepares a file that was already read
Surface_input prepare(Surface_file file);

/// a mesh as if it had been read
Surface_input as_input(const CGP::Mesh_view& mesh);

/// names with the numbers of the file, which count from 0; for OBJ also the number that its faces
/// use: `vertex 17 (number 18 in the OBJ file)`
std::string name_of_vertex(const Surface_input& input, int v);
std::string name_of_face(const Surface_input& input, int f);
std::string name_of_edge(const Surface_input& input, int k);

/// one value per vertex of the file from one per vertex of the mesh
std::vector<double> to_file_vertices(const Surface_input& input, const Eigen::VectorXd& values,
                                     double elsewhere);

}  // namespace conformal
