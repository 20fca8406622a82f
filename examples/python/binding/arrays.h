// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>

#include <string>

/// NumPy's arrays have one element per row, the matrices of the library one per column: both put
/// the numbers of an element next to each other.
namespace conformal_python {

namespace py = pybind11;
namespace CGP = Conformal_geometry_processing;

using Array = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::int64_t, py::array::c_style>;
using Spins = CGP::Quaternion_vector<double>;

/// \param V n x 3 \param F m x 3
/// \throw Precondition_error if a shape is wrong, or an index is out of range, naming the face
CGP::Mesh_view mesh_view(const Array& V, const Indices& F, const std::string& function);

/// \param what is named if the shape is not n x 3
CGP::Points points(const Array& V, const std::string& function, const std::string& what);

/// \throw Precondition_error if there is not one row of three numbers for each of `rows` vertices
CGP::Points vertex_points(const Array& V, Eigen::Index rows, const std::string& function,
                          const std::string& what);

/// one number per entry; any shape but that of one dimension is refused
Eigen::VectorXd numbers(const Array& values, const std::string& function, const std::string& what);

/// \param k numbers in each of k columns, or one column for an array of one dimension
Eigen::MatrixXd columns(const Array& values, Eigen::Index rows, const std::string& function);

/// \param on "vertices", "faces", or empty: by the number of the values
CGP::Curvature_potential potential(const Array& rho, const std::string& on,
                                   const CGP::Mesh_view& mesh, const std::string& function);

/// \param lambda n x 4, (w, x, y, z)
Spins spins(const Array& lambda, const std::string& function);

Array to_rows(const CGP::Points& p);
Array to_rows(const Spins& lambda);

}  // namespace conformal_python
