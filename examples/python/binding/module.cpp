// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "binding.h"

#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/version.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <exception>

namespace {

namespace py = pybind11;
namespace CGP = Conformal_geometry_processing;

void raise(const char* type, const CGP::Error& error)
{
  const py::object exception = py::module_::import("conformal_geometry._errors").attr(type);
  const py::object raised = exception(error.function(), error.message());
  PyErr_SetObject(exception.ptr(), raised.ptr());
}

void translate(std::exception_ptr pending)
{
  try {
    if (pending) std::rethrow_exception(pending);
  } catch (const CGP::Precondition_error& error) {
    raise("Precondition_error", error);
  } catch (const CGP::Solver_error& error) {
    raise("Solver_error", error);
  }
}

}  // namespace

PYBIND11_MODULE(_kernels, m)
{
  m.doc() = "The compiled kernels; private, see conformal_geometry.";
  m.attr("__version__") = CONFORMAL_GEOMETRY_PROCESSING_VERSION;
  m.attr("default_max_scale") = CGP::internal::default_scale_bound;
  py::register_exception_translator(translate);
  conformal_python::add_spin(m);
  conformal_python::add_deform(m);
  conformal_python::add_fit(m);
  conformal_python::add_derivative(m);
  conformal_python::add_flow(m);
  conformal_python::add_surfaces(m);
  conformal_python::add_matrices(m);
}
