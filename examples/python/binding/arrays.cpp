// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "arrays.h"

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <utility>

namespace conformal_python {
namespace {

std::string shape_of(const py::array& a)
{
  return py::str(a.attr("shape"));
}

void require_width(const py::array& a, py::ssize_t width, const std::string& function,
                   const std::string& what)
{
  if (a.ndim() != 2 || a.shape(1) != width)
    throw CGP::Precondition_error(function, what + " of the shape " + shape_of(a) + "; (n, " +
                                                std::to_string(width) + ") is needed");
}

Array empty(Eigen::Index rows, Eigen::Index columns)
{
  return Array(std::vector<py::ssize_t>{rows, columns});
}

std::string name_of_row(const Indices& F, int f)
{
  return "face " + std::to_string(f) + " (vertices " + std::to_string(F.at(f, 0)) + ", " +
         std::to_string(F.at(f, 1)) + ", " + std::to_string(F.at(f, 2)) + ")";
}

void require_indices(const Indices& F, Eigen::Index vertices, const std::string& function)
{
  const auto is_bad = [&](int f) {
    for (int c = 0; c < 3; ++c)
      if (F.at(f, c) < 0 || F.at(f, c) >= vertices) return true;
    return false;
  };
  CGP::internal::refuse_if_any(
      static_cast<int>(F.shape(0)), is_bad, [&](int f) { return name_of_row(F, f); }, function,
      "#face with an index out of range",
      "the indices of " + std::to_string(vertices) + " vertices begin with 0");
}

}  // namespace

CGP::Mesh_view mesh_view(const Array& V, const Indices& F, const std::string& function)
{
  CGP::Points positions = points(V, function, "points");
  require_width(F, 3, function, "faces");
  require_indices(F, positions.cols(), function);
  CGP::Mesh_view::Corners corners(static_cast<std::size_t>(F.shape(0)));
  for (std::size_t f = 0; f < corners.size(); ++f)
    for (std::size_t c = 0; c < 3; ++c)
      corners[f][c] = static_cast<int>(F.at(static_cast<py::ssize_t>(f), c));
  return {std::move(positions), std::move(corners)};
}

CGP::Points points(const Array& V, const std::string& function, const std::string& what)
{
  require_width(V, 3, function, what);
  return Eigen::Map<const Eigen::Matrix3Xd>(V.data(), 3, V.shape(0));
}

CGP::Points vertex_points(const Array& V, Eigen::Index rows, const std::string& function,
                          const std::string& what)
{
  CGP::Points p = points(V, function, what);
  if (p.cols() != rows)
    throw CGP::Precondition_error(function,
                                  std::to_string(p.cols()) + " " + what +
                                      ", one per vertex is needed: " + std::to_string(rows));
  return p;
}

Eigen::VectorXd numbers(const Array& values, const std::string& function, const std::string& what)
{
  if (values.ndim() != 1)
    throw CGP::Precondition_error(
        function, what + " of the shape " + shape_of(values) + "; one dimension is needed");
  return Eigen::Map<const Eigen::VectorXd>(values.data(), values.size());
}

Eigen::MatrixXd columns(const Array& values, Eigen::Index rows, const std::string& function)
{
  if (values.ndim() > 2 || values.ndim() == 0 || values.shape(0) != rows)
    throw CGP::Precondition_error(function, "an array of the shape " + shape_of(values) + "; " +
                                                std::to_string(rows) + " rows are needed");
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(values.data(), rows, values.ndim() == 2 ? values.shape(1) : 1);
}

CGP::Curvature_potential potential(const Array& rho, const std::string& on,
                                   const CGP::Mesh_view& mesh, const std::string& function)
{
  Eigen::VectorXd values = numbers(rho, function, "rho");
  const bool fits_vertices = values.size() == mesh.size_of_vertices();
  const bool fits_faces = values.size() == mesh.size_of_faces();
  if (on.empty() && fits_vertices && fits_faces)
    throw CGP::Precondition_error(
        function, "the mesh has as many faces as vertices; say on='vertices' or on='faces'");
  if (!on.empty() && on != "vertices" && on != "faces")
    throw CGP::Precondition_error(function, "on='" + on + "'; 'vertices' or 'faces' is needed");
  const bool on_faces = on.empty() ? fits_faces : on == "faces";
  return on_faces ? CGP::Curvature_potential::on_faces(std::move(values))
                  : CGP::Curvature_potential::on_vertices(std::move(values));
}

Spins spins(const Array& lambda, const std::string& function)
{
  require_width(lambda, 4, function, "spins");
  Spins v(lambda.shape(0));
  CGP::components(v) = Eigen::Map<const Eigen::Matrix4Xd>(lambda.data(), 4, lambda.shape(0));
  return v;
}

Array to_rows(const CGP::Points& p)
{
  Array rows = empty(p.cols(), 3);
  Eigen::Map<Eigen::Matrix3Xd>(rows.mutable_data(), 3, p.cols()) = p;
  return rows;
}

Array to_rows(const Spins& lambda)
{
  Array rows = empty(lambda.size(), 4);
  Eigen::Map<Eigen::Matrix4Xd>(rows.mutable_data(), 4, lambda.size()) = CGP::components(lambda);
  return rows;
}

}  // namespace conformal_python
