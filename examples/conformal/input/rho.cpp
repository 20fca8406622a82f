// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "rho.h"

#include "Expression.h"
#include "filter_rho.h"

#include "conformal/process/Failure.h"
#include "conformal/process/text.h"

#include <Conformal_geometry_processing/mesh/normals.h>

#include <cmath>

namespace conformal {
namespace {

CGP::Curvature_potential rho_from(const Surface_input& input, const Rho_options& options)
{
  if (!options.expression.empty()) return rho_from_expression(input, options);
  if (!options.property.empty()) return rho_from_property(input, options);
  if (!options.file.empty()) return rho_from_file(input, options);
  return rho_from_image(input, options);
}

void require_finite(const Surface_input& input, const CGP::Curvature_potential& rho)
{
  int first = -1;
  std::size_t count = 0;
  for (int i = 0; i < rho.values.size(); ++i)
    if (!std::isfinite(rho.values[i]) && count++ == 0) first = i;
  if (count == 0) return;
  const bool on_faces = rho.on == CGP::Curvature_potential::On::faces;
  throw unsuitable(
      input.file.path,
      "rho is not a finite number at " + count_of(count, on_faces ? "face" : "vertex") +
          " (first: " + (on_faces ? name_of_face(input, first) : name_of_vertex(input, first)) +
          "), wanted finite values everywhere; try: a formula or data without them");
}

}  // namespace

Eigen::VectorXd vertex_numbers(const Surface_input& input, const std::string& option,
                               const std::string& expression, const std::string& property)
{
  Rho_options source;
  source.expression = expression;
  source.property = property;
  source.on_faces = false;
  if (!expression.empty()) return rho_from_expression(input, source, option).values;
  if (!property.empty()) return rho_from_property(input, source).values;
  return {};
}

CGP::Curvature_potential rho_from_expression(const Surface_input& input, const Rho_options& options,
                                             const std::string& option)
{
  Expression expression(options.expression, option);
  const User_frame frame(input.mesh);
  const CGP::Mesh_view& mesh = input.mesh;
  if (options.on_faces.value_or(false)) {
    const CGP::Points normals = CGP::face_normals(mesh);
    Eigen::VectorXd values(mesh.size_of_faces());
    for (int f = 0; f < mesh.size_of_faces(); ++f) {
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const int v : mesh.corners(f)) middle += frame(mesh.position(v)) / 3;
      values[f] = expression(middle, normals.col(f));
    }
    return CGP::Curvature_potential::on_faces(std::move(values));
  }
  const CGP::Points normals = CGP::vertex_normals(mesh);
  Eigen::VectorXd values(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    values[v] = expression(frame(mesh.position(v)), normals.col(v));
  return CGP::Curvature_potential::on_vertices(std::move(values));
}

CGP::Curvature_potential read_rho(const Surface_input& input, const Rho_options& options)
{
  require_possible_filter(options);
  CGP::Curvature_potential rho = rho_from(input, options);
  rho.values *= options.amplitude;
  require_finite(input, rho);
  return is_filtered_on_surface(options) ? filtered(input, rho, options.filter) : rho;
}

}  // namespace conformal
