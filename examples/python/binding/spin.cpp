// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "binding.h"
#include "transformation.h"

#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

#include <atomic>
#include <memory>
#include <utility>

namespace conformal_python {
namespace {

/// `Spin_transformation` on arrays, used by one thread at a time
class Transformation {
 public:
  Transformation(const Array& V, const Indices& F, const py::dict& options, std::string function)
      : m_function(std::move(function)), m_mesh(mesh_view(V, F, m_function))
  {
    const auto own = transformation_options(options, m_mesh, m_function);
    m_transformation = without_lock(
        [&] { return std::make_unique<CGP::Spin_transformation>(m_mesh, own, m_function); });
  }

  py::tuple transform(const Array& rho, const std::string& on, const py::dict& options,
                      const py::dict& bounds, const py::object& callback)
  {
    const CGP::Curvature_potential potential =
        conformal_python::potential(rho, on, m_mesh, m_function);
    const CGP::Dirac_options dirac = dirac_options(options, m_function);
    const Watch watch(callback);
    const Turn turn(m_is_computing, m_function);
    m_transformation->dirac() = dirac;
    m_transformation->limits() = limits(bounds);
    return as_tuple(
        without_lock([&] { return m_transformation->transform(potential, std::cref(watch)); }));
  }

  py::tuple integrate(const Array& lambda)
  {
    const Turn turn(m_is_computing, m_function);
    Spins given = spins(lambda, m_function);
    m_transformation->limits() = {};
    return as_tuple(without_lock([&] { return m_transformation->integrate(std::move(given)); }));
  }

  void set_positions(const Array& V)
  {
    const Turn turn(m_is_computing, m_function);
    const CGP::Points p = points(V, m_function, "points");
    without_lock([&] { m_transformation->set_positions(p); });
    m_mesh.set_positions(p);
  }

  Array positions() const { return to_rows(m_mesh.positions()); }

 private:
  std::string m_function;
  CGP::Mesh_view m_mesh;
  std::unique_ptr<CGP::Spin_transformation> m_transformation;
  std::atomic_flag m_is_computing = ATOMIC_FLAG_INIT;
};

py::tuple minimal_surface(const Array& V, const Indices& F, const py::object& boundary,
                          const py::dict& options, const py::object& callback)
{
  const std::string function = "minimal_surface";
  const CGP::Mesh_view mesh = mesh_view(V, F, function);
  CGP::Spin_transformation_options request{boundary_condition(boundary, mesh, function)};
  if (request.boundary.kind == CGP::Boundary_condition::Kind::free)
    request.boundary = CGP::Boundary_condition::tangents();
  request.dirac = dirac_options(options, function);
  const Watch watch(callback);
  return as_tuple(without_lock(
      [&] { return CGP::spin_to_minimal_surface(mesh, request, function, std::cref(watch)); }));
}

}  // namespace

void add_spin(py::module_& m)
{
  using py::arg;
  py::class_<Transformation>(m, "Transformation")
      .def(py::init<const Array&, const Indices&, const py::dict&, std::string>(), arg("V"),
           arg("F"), arg("options"), arg("function"))
      .def("transform", &Transformation::transform, arg("rho"), arg("on"), arg("options"),
           arg("limits"), arg("callback"))
      .def("integrate", &Transformation::integrate, arg("spins"))
      .def("set_positions", &Transformation::set_positions, arg("V"))
      .def("positions", &Transformation::positions);
  m.def("minimal_surface", &minimal_surface, arg("V"), arg("F"), arg("boundary"), arg("options"),
        arg("callback"));
}

}  // namespace conformal_python
