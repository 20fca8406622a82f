// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "binding.h"
#include "options.h"
#include "reports.h"
#include "watch.h"

#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Conformal_geometry_processing/spin/snap_to_class.h>

#include <array>
#include <cstddef>
#include <vector>

namespace conformal_python {
namespace {

/// (uv, report)
py::tuple flatten(const Array& V, const Indices& F, const py::dict& options)
{
  const std::string function = "flatten";
  using Normals = CGP::Parameterization_options::Normals;
  using Boundary = CGP::Parameterization_options::Boundary;
  CGP::Parameterization_options o;
  choose(options, "normals", {{"faces", Normals::of_faces}, {"vertices", Normals::of_vertices}},
         o.normals, function);
  choose(options, "boundary",
         {{"longest_loop", Boundary::longest_loop}, {"all_loops", Boundary::all_loops}}, o.boundary,
         function);
  take(options, "tolerance", o.tolerance);
  take(options, "max_iterations", o.maximum_number_of_iterations);
  const CGP::Mesh_view mesh = mesh_view(V, F, function);
  const auto result =
      without_lock([&] { return CGP::spectral_parameterization(mesh, o, function); });
  Array uv(std::vector<py::ssize_t>{result.z.size(), 2});
  Eigen::Map<Eigen::VectorXcd>(reinterpret_cast<std::complex<double>*>(uv.mutable_data()),
                               result.z.size()) = result.z;
  return py::make_tuple(uv, as_dict(result.report));
}

/// (|E| x 2 ends, |E| x k forms, [|F| x 3 fields])
py::tuple harmonic_basis(const Array& V, const Indices& F)
{
  const std::string function = "harmonic_basis";
  CGP::Mesh_view mesh = mesh_view(V, F, function);
  require_surface(mesh, function);
  const CGP::internal::Normalized_frame frame(mesh.positions());
  mesh.set_positions(frame.to_frame(mesh.positions()));
  CGP::Harmonic_basis basis =
      without_lock([&] { return CGP::Hodge_decomposition(mesh, function).harmonic_basis(); });
  py::array_t<int> ends({mesh.size_of_edges(), 2});
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (int end = 0; end < 2; ++end)
      ends.mutable_at(k, end) = mesh.ends(k)[static_cast<std::size_t>(end)];
  Array forms(std::vector<py::ssize_t>{basis.one_forms.rows(), basis.one_forms.cols()});
  for (Eigen::Index i = 0; i < basis.one_forms.rows(); ++i)
    for (Eigen::Index j = 0; j < basis.one_forms.cols(); ++j)
      forms.mutable_at(i, j) = basis.one_forms(i, j);
  py::list fields;
  for (const CGP::Points& field : basis.fields)
    fields.append(to_rows(CGP::Points(field / frame.unit())));
  return py::make_tuple(ends, forms, fields);
}

py::dict spectrum_as_dict(const CGP::internal::Dirac_spectrum& s)
{
  using namespace pybind11::literals;
  const auto vector = [](const Eigen::VectorXd& v) { return Array(v.size(), v.data()); };
  py::list eigenfunctions;
  for (Eigen::Index k = 0; k < s.vectors.cols(); ++k)
    eigenfunctions.append(to_rows(Spins(s.vectors.col(k))));
  return py::dict(
      "shift"_a = s.shift, "wanted"_a = s.wanted, "eigenvalues"_a = vector(s.eigenvalues),
      "pencil_eigenvalues"_a = vector(s.pencil_eigenvalues), "residuals"_a = vector(s.residuals),
      "vectors"_a = eigenfunctions, "size_of_constants"_a = s.size_of_constants,
      "complete_radius"_a = s.complete_radius, "restarts"_a = s.restarts,
      "converged"_a = s.converged, "cancelled"_a = s.cancelled, "is_complete"_a = s.is_complete());
}

py::dict dirac_spectrum(const Array& V, const Indices& F, int count, const py::object& rho,
                        const std::string& on, const py::dict& options)
{
  const std::string function = "dirac_spectrum";
  const CGP::Mesh_view mesh = mesh_view(V, F, function);
  require_surface(mesh, function);
  py::object given = py::none();
  take(options, "boundary", given);
  CGP::Boundary_condition condition = boundary_condition(given, mesh, function);
  if (condition.kind == CGP::Boundary_condition::Kind::free && !CGP::topology(mesh).is_closed())
    condition = CGP::Boundary_condition::binormals();
  const CGP::Curvature_potential curvature =
      rho.is_none() ? no_potential(mesh) : potential(rho.cast<Array>(), on, mesh, function);
  CGP::internal::Dirac_spectrum_options o;
  take(options, "shift", o.shift);
  take(options, "tolerance", o.tolerance);
  take(options, "max_restarts", o.max_restarts);
  take(options, "random_seed", o.random_seed);
  return spectrum_as_dict(without_lock([&] {
    return CGP::internal::Dirac_spectral_problem(mesh, condition, function)
        .find(curvature, count, o, [](const CGP::internal::Krylov_progress&) {
          const py::gil_scoped_acquire lock;
          raise_signals();
          return true;
        });
  }));
}

/// (positions, report)
py::tuple snap(const Array& V, const Array& reference, const Indices& F, bool on_delaunay,
               double tolerance, int max_iterations)
{
  const std::string function = "snap_to_conformal_class";
  const CGP::Mesh_view mesh = mesh_view(V, F, function), other = mesh_view(reference, F, function);
  CGP::internal::require_edge_lengths(mesh, function);
  vertex_points(reference, mesh.size_of_vertices(), function, "reference points");
  CGP::internal::require_edge_lengths(other, function);
  CGP::internal::Snap_options options;
  options.tolerance = tolerance / 4;  // of a residual; a change sums four
  options.max_iterations = max_iterations;
  CGP::Points positions = mesh.positions();
  const auto report = without_lock([&] {
    return CGP::internal::snap_to_class(on_delaunay ? CGP::internal::simple_delaunay(other) : other,
                                        positions, options);
  });
  return py::make_tuple(to_rows(positions), as_dict(report));
}

/// (|F| x 3 corners, number of flips)
py::tuple make_delaunay(const Array& V, const Indices& F)
{
  const std::string function = "make_delaunay";
  const CGP::Mesh_view mesh = mesh_view(V, F, function);
  CGP::internal::require_edge_lengths(mesh, function);
  std::vector<std::array<int, 2>> flips;
  const CGP::Mesh_view flipped =
      without_lock([&] { return CGP::internal::delaunay_by_chords(mesh, 0, flips); });
  py::array_t<int> corners({flipped.size_of_faces(), 3});
  for (int f = 0; f < flipped.size_of_faces(); ++f)
    for (int c = 0; c < 3; ++c)
      corners.mutable_at(f, c) = flipped.corners(f)[static_cast<std::size_t>(c)];
  return py::make_tuple(corners, flips.size());
}

}  // namespace

void add_surfaces(py::module_& m)
{
  using py::arg;
  m.def("flatten", &flatten, arg("V"), arg("F"), arg("options"));
  m.def("harmonic_basis", &harmonic_basis, arg("V"), arg("F"));
  m.def("dirac_spectrum", &dirac_spectrum, arg("V"), arg("F"), arg("count"), arg("rho"), arg("on"),
        arg("options"));
  m.def("snap_to_conformal_class", &snap, arg("V"), arg("reference"), arg("F"), arg("on_delaunay"),
        arg("tolerance"), arg("max_iterations"));
  m.def("make_delaunay", &make_delaunay, arg("V"), arg("F"));
}

}  // namespace conformal_python
