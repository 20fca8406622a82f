// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Component.h"

#include "conformal/io/write_surface.h"
#include "conformal/report/Session.h"

#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <string>
#include <vector>

namespace conformal {

/// A computed surface, and what is written with it; a component that was not computed stays as it
/// was.
struct Transformed_surface {
  CGP::Points positions;
  CGP::Quaternion_vector<double> lambda = {};  ///< none if empty
  CGP::Curvature_potential rho = {};           ///< in the *user's frame*; none if empty

  /// the surface as it is, with lambda = 1
  static Transformed_surface unchanged(const CGP::Mesh_view& mesh);

  void set(const Component& component, const CGP::Spin_result& solution);
};

/// Refuses before the work an output that cannot be written after it. \throws Write_error
void require_writable(const std::string& path);

/// the input's file with other positions: normals, which are wrong now, are left out; vertices
/// without a face stay where they are
Surface_file moved(const Surface_input& input, const CGP::Points& positions);

/// the quasi-conformal error at each vertex of the file, averaged by area; 1 elsewhere
std::vector<float> quality(const Surface_input& input, const CGP::Points& positions);

/// Sets it as the vertex property `quality`.
void set_quality(const Surface_input& input, const CGP::Points& positions, Surface_file& file);

/// rho on faces: the mean of the corners, if it is on vertices
Eigen::VectorXd at_faces(const CGP::Mesh_view& mesh, const CGP::Curvature_potential& rho);

/// the file of a result: moved, with `quality`, `rho` and, if a name is given, lambda as vertex
/// properties `<name>_w` to `<name>_z`
Surface_file result_file(const Surface_input& input, const Transformed_surface& surface,
                         const std::string& lambda = "");

/// how the options want PLY
Ply_style ply_style(const Common_options& options);

/// Writes a mesh as the options say, and notes what was left out. \throws Write_error
void write_mesh(const std::string& path, const Surface_file& file, Session& session);

/// Writes the result to the output, and stores it for the HTML report. \throws Write_error
void write_result(const Surface_input& input, const Transformed_surface& surface, Session& session,
                  const std::string& lambda = "");

}  // namespace conformal
