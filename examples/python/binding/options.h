// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "arrays.h"

#include <Conformal_geometry_processing/forms/exactness_functions.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <pybind11/stl.h>

#include <string>
#include <utility>

namespace conformal_python {

/// Reads `value` from an option by name; unless it is there and not None, the default stays.
/// \throw TypeError naming the option
template <class T>
void take(const py::dict& options, const char* name, T& value)
{
  if (!options.contains(name) || options[name].is_none()) return;
  try {
    value = options[name].cast<T>();
  } catch (const py::cast_error&) {
    throw py::type_error(std::string(name) +
                         " is of an unsuitable type: " + std::string(py::repr(options[name])));
  }
}

/// Reads a choice by its name.
/// \throw Precondition_error naming the choices
template <class T>
void choose(const py::dict& options, const char* name,
            std::initializer_list<std::pair<const char*, T>> choices, T& value,
            const std::string& function)
{
  std::string chosen, all;
  take(options, name, chosen);
  if (chosen.empty()) return;
  for (const auto& [text, choice] : choices) {
    if (chosen == text) {
      value = choice;
      return;
    }
    all += (all.empty() ? "'" : ", '") + std::string(text) + "'";
  }
  throw CGP::Precondition_error(
      function, std::string(name) + " is '" + chosen + "'; one of these is needed: " + all);
}

/// The numbers of an array, none without one.
/// \throw Precondition_error if there is an array without numbers, which would count as none
Eigen::VectorXd take_numbers(const py::dict& options, const char* name,
                             const std::string& function);

/// exactness (adjoint, thesis, or None for none), max_period_defect and mollification
void take_closing(const py::dict& options, const std::string& function,
                  CGP::Spin_transformation_options& o);

/// three numbers
Eigen::Vector3d direction_of(const py::object& direction, const std::string& function);

/// \param condition a Boundary_condition of Python, or None
CGP::Boundary_condition boundary_condition(const py::object& condition, const CGP::Mesh_view& mesh,
                                           const std::string& function);

CGP::Dirac_options dirac_options(const py::dict& options, const std::string& function);

/// boundary, exact_conformal_class, and how the surface is closed and mollified
void take_surface(const py::dict& options, const CGP::Mesh_view& mesh, const std::string& function,
                  CGP::Spin_transformation_options& o);

/// The options of a transformation; max_scale None is no bound, and without it that is the default.
CGP::Spin_transformation_options transformation_options(const py::dict& options,
                                                        const CGP::Mesh_view& mesh,
                                                        const std::string& function);

CGP::Spin_report::Limits limits(const py::dict& options);

}  // namespace conformal_python
