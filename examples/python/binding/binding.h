// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

/// The parts of the module, one file each. Private: Python's layer has the names, the defaults and
/// the documentation.
namespace conformal_python {

void add_spin(pybind11::module_& m);
void add_deform(pybind11::module_& m);
void add_fit(pybind11::module_& m);
void add_derivative(pybind11::module_& m);
void add_flow(pybind11::module_& m);
void add_surfaces(pybind11::module_& m);
void add_matrices(pybind11::module_& m);

}  // namespace conformal_python
