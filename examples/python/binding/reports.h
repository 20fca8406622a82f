// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Flow_report.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/snap_to_class.h>

#include <pybind11/pybind11.h>

/// The fields of the reports by their names, from which Python makes its data classes; `fault` is
/// the verdict as text, None where the result is what was asked for.
namespace conformal_python {

namespace py = pybind11;
namespace CGP = Conformal_geometry_processing;

py::dict as_dict(const CGP::internal::Distribution& d);
py::dict as_dict(const CGP::Conformality& c);
py::dict as_dict(const CGP::Spin_report& r);
py::dict as_dict(const CGP::Flow_step_report& r);
py::dict as_dict(const CGP::Flow_report& r);
py::dict as_dict(const CGP::Parameterization_report& r);
py::dict as_dict(const CGP::internal::Class_snap_report& r);

}  // namespace conformal_python
