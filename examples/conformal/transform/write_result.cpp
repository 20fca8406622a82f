// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_result.h"

#include "conformal/io/file/Temporary_file.h"
#include "conformal/report/keep_exhibit.h"

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <filesystem>
#include <system_error>

namespace conformal {
namespace {

// Q of the faces as values of the vertices; as large as a float can be where a face is squashed.
// Faces of area zero have no angles, and do not count.
Eigen::VectorXd quality_at_vertices(const CGP::Mesh_view& mesh, const CGP::Points& positions)
{
  const double largest = 1e30;
  const Eigen::VectorXd Q = CGP::quasi_conformal_errors(mesh, positions).cwiseMin(largest);
  const Eigen::VectorXd areas = CGP::face_areas(mesh);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.size_of_vertices()), weight = sum;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (const int v : mesh.corners(f)) {
      if (CGP::has_area_zero(mesh, f)) continue;
      sum[v] += areas[f] * Q[f];
      weight[v] += areas[f];
    }
  const auto has_none = weight.array() == 0;
  return has_none.select(1, sum.cwiseQuotient(has_none.select(1, weight)));
}

void set_rho(const Surface_input& input, const CGP::Curvature_potential& rho, Surface_file& file)
{
  if (rho.on == CGP::Curvature_potential::On::vertices)
    return set_property(file.vertices, "rho", to_file_vertices(input, rho.values, 0));
  // The triangles of a polygon may differ: their mean.
  std::vector<double> sum(file.polygons.size(), 0), count(sum);
  for (std::size_t t = 0; t < input.face_in_file.size(); ++t) {
    const auto f = static_cast<std::size_t>(input.face_in_file[t]);
    sum[f] += rho.values[static_cast<Eigen::Index>(t)];
    count[f] += 1;
  }
  for (std::size_t f = 0; f < sum.size(); ++f) sum[f] /= count[f];
  set_property(file.faces, "rho", sum);
}

void set_lambda(const Surface_input& input, const CGP::Quaternion_vector<double>& lambda,
                const std::string& name, Surface_file& file)
{
  const auto all = CGP::components(lambda);  // rows w, x, y, z
  const char* const suffixes[] = {"_w", "_x", "_y", "_z"};
  for (Eigen::Index i = 0; i < 4; ++i)
    set_property(file.vertices, name + suffixes[i],
                 to_file_vertices(input, all.row(i).transpose(), i == 0 ? 1 : 0));
}

void report_rho(const CGP::Mesh_view& mesh, const CGP::Curvature_potential& rho, Outcome& outcome)
{
  const bool on_faces = rho.on == CGP::Curvature_potential::On::faces;
  outcome.report.set("result/rho/on", on_faces ? "faces" : "vertices");
  outcome.report.set("result/rho/min", rho.values.minCoeff());
  outcome.report.set("result/rho/max", rho.values.maxCoeff());
  if (outcome.exhibit) outcome.exhibit->rho = at_faces(mesh, rho);
}

}  // namespace

Eigen::VectorXd at_faces(const CGP::Mesh_view& mesh, const CGP::Curvature_potential& rho)
{
  if (rho.on == CGP::Curvature_potential::On::faces) return rho.values;
  Eigen::VectorXd values(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    values[f] = (rho.values[v[0]] + rho.values[v[1]] + rho.values[v[2]]) / 3;
  }
  return values;
}

Transformed_surface Transformed_surface::unchanged(const CGP::Mesh_view& mesh)
{
  return {mesh.positions(), CGP::Quaternion_vector<double>::Constant(
                                mesh.size_of_vertices(), CGP::Quaternion<double>{1, 0, 0, 0})};
}

void Transformed_surface::set(const Component& component, const CGP::Spin_result& solution)
{
  positions(Eigen::indexing::all, component.vertices) = solution.positions;
  lambda(component.vertices) = solution.lambda;
}

void require_writable(const std::string& path)
{
  output_format(path);
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  // Not devices and pipes, which notice when they are opened.
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status))
    Temporary_file probe(path);
}

Surface_file moved(const Surface_input& input, const CGP::Points& positions)
{
  Surface_file file = input.file;
  for (std::size_t v = 0; v < input.vertex_in_file.size(); ++v) {
    const Eigen::Vector3d p = positions.col(static_cast<Eigen::Index>(v));
    file.points[static_cast<std::size_t>(input.vertex_in_file[v])] = {p.x(), p.y(), p.z()};
  }
  if (remove_normals(file))
    file.notes.emplace_back("normals are left out, for the points have moved");
  return file;
}

std::vector<float> quality(const Surface_input& input, const CGP::Points& positions)
{
  std::vector<float> values;
  for (const double q : to_file_vertices(input, quality_at_vertices(input.mesh, positions), 1))
    values.push_back(static_cast<float>(q));
  return values;
}

void set_quality(const Surface_input& input, const CGP::Points& positions, Surface_file& file)
{
  set_property(file.vertices, "quality", quality(input, positions));
}

Surface_file result_file(const Surface_input& input, const Transformed_surface& surface,
                         const std::string& lambda)
{
  Surface_file file = moved(input, surface.positions);
  set_quality(input, surface.positions, file);
  if (surface.rho.values.size() > 0) set_rho(input, surface.rho, file);
  if (!lambda.empty()) set_lambda(input, surface.lambda, lambda, file);
  return file;
}

Ply_style ply_style(const Common_options& options)
{
  return {options.ascii ? Ply_encoding::ascii : Ply_encoding::little_endian,
          options.is_single ? Value_type::float32 : Value_type::float64};
}

void write_mesh(const std::string& path, const Surface_file& file, Session& session)
{
  session.note_all(write_surface(path, file, ply_style(session.options())));
}

void write_result(const Surface_input& input, const Transformed_surface& surface, Session& session,
                  const std::string& lambda)
{
  const CGP::Curvature_potential& rho = surface.rho;
  keep_exhibit(input, surface.positions, session);
  if (rho.values.size() > 0) report_rho(input.mesh, rho, session.outcome());
  write_mesh(session.options().output, result_file(input, surface, lambda), session);
  session.end_stage("write");
}

}  // namespace conformal
