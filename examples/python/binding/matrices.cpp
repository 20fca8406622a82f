// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "binding.h"
#include "options.h"

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <vector>

namespace conformal_python {
namespace {

CGP::Mesh_view surface(const Array& V, const Indices& F, const std::string& function)
{
  CGP::Mesh_view mesh = mesh_view(V, F, function);
  require_surface(mesh, function);
  return mesh;
}

Array to_array(const Eigen::VectorXd& v)
{
  return Array(v.size(), v.data());
}

/// the entries of a matrix: rows, columns, and one number or quaternion each
class Entries {
 public:
  void add(int row, int column, double value) { put(row, column), m_values.push_back(value); }

  void add(int row, int column, const CGP::Quaternion<double>& q)
  {
    put(row, column);
    m_values.insert(m_values.end(), {q.w, q.x, q.y, q.z});
  }

  py::tuple as_tuple() const
  {
    const auto count = static_cast<py::ssize_t>(m_rows.size());
    return py::make_tuple(py::array_t<int>(count, m_rows.data()),
                          py::array_t<int>(count, m_columns.data()),
                          Array(static_cast<py::ssize_t>(m_values.size()), m_values.data()));
  }

 private:
  void put(int row, int column)
  {
    m_rows.push_back(row);
    m_columns.push_back(column);
  }

  std::vector<int> m_rows, m_columns;
  std::vector<double> m_values;
};

/// all entries, of which the library stores those of one triangle
template <class Scalar>
py::tuple entries_of(const CGP::Hermitian_sparse_matrix<Scalar>& A)
{
  using CGP::conjugate;
  Entries entries;
  A.for_each_entry([&](int i, int j, const Scalar& value) {
    entries.add(i, j, value);
    if (i == j) return;
    if constexpr (std::is_same_v<Scalar, double>)
      entries.add(j, i, value);
    else
      entries.add(j, i, conjugate(value));
  });
  return entries.as_tuple();
}

py::tuple dirac(const Array& V, const Indices& F)
{
  const CGP::Mesh_view mesh = surface(V, F, "dirac_operator");
  const auto D = CGP::dirac(mesh);
  Entries entries;
  for (int f = 0; f < D.rows(); ++f)
    for (int c = 0; c < 3; ++c) entries.add(f, D.column(f, c), D.value(f, c));
  return entries.as_tuple();
}

py::tuple dirac_energy(const Array& V, const Indices& F, const py::object& rho,
                       const std::string& on)
{
  const std::string function = "dirac_energy";
  const CGP::Mesh_view mesh = surface(V, F, function);
  const CGP::Curvature_potential curvature =
      rho.is_none() ? no_potential(mesh) : potential(rho.cast<Array>(), on, mesh, function);
  require_potential(mesh, curvature, 1, function);
  return entries_of(CGP::dirac_energy(mesh, curvature));
}

Array quasi_conformal_errors(const Array& V, const Indices& F, const Array& moved)
{
  const std::string function = "quasi_conformal_errors";
  const CGP::Mesh_view mesh = surface(V, F, function);
  return to_array(CGP::quasi_conformal_errors(
      mesh, vertex_points(moved, mesh.size_of_vertices(), function, "new points")));
}

}  // namespace

void add_matrices(py::module_& m)
{
  using py::arg;
  m.def("dirac_operator", &dirac, arg("V"), arg("F"));
  m.def("dirac_energy", &dirac_energy, arg("V"), arg("F"), arg("rho"), arg("on"));
  m.def(
      "cotan_laplacian",
      [](const Array& V, const Indices& F) {
        return entries_of(CGP::cotan_laplacian(surface(V, F, "cotan_laplacian")));
      },
      arg("V"), arg("F"));
  m.def(
      "vertex_areas",
      [](const Array& V, const Indices& F) {
        return to_array(CGP::vertex_areas(surface(V, F, "vertex_areas")));
      },
      arg("V"), arg("F"));
  m.def(
      "face_areas",
      [](const Array& V, const Indices& F) {
        return to_array(CGP::face_areas(surface(V, F, "face_areas")));
      },
      arg("V"), arg("F"));
  m.def(
      "mean_curvature",
      [](const Array& V, const Indices& F) {
        return to_array(CGP::mean_curvature(surface(V, F, "mean_curvature")));
      },
      arg("V"), arg("F"));
  m.def("quasi_conformal_errors", &quasi_conformal_errors, arg("V"), arg("F"), arg("moved"));
}

}  // namespace conformal_python
