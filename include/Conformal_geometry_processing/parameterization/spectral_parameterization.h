// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/parameterization/Least_energy_map.h>
#include <Conformal_geometry_processing/parameterization/Parameterization_report.h>
#include <Conformal_geometry_processing/parameterization/conformal_energy.h>
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>
#include <Conformal_geometry_processing/parameterization/vertex_normal_energy.h>

#include <Eigen/Core>

#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// Options of `spectral_parameterization()`
struct Parameterization_options {
  using Boundary = internal::Normalized_boundary;  ///< which loops are normalized

  /// \brief Normals N in the energy |D psi|^2 of psi = a - b N [CGP 6.1].
  enum class Normals {
    of_faces,    ///< the conformal energy itself, see `conformal_energy()`
    of_vertices  ///< the variant of the thesis, see `vertex_normal_energy()`
  };

  Normals normals = Normals::of_faces;
  internal::Normal_weight vertex_normals =
      internal::Normal_weight::angle;  ///< of `Parameterization_options::Normals::of_vertices`
  internal::Normalized_boundary boundary = internal::Normalized_boundary::longest_loop;
  double tolerance = 1e-6;  ///< of the relative error of the map in the norm of the energy
  int maximum_number_of_iterations = 100;
  Map_solvers solvers = {};  ///< for the linear systems
};

namespace internal {

/// \ingroup PkgParameterization
/// A map to the plane and its quality measures
struct Parameterization_result {
  Eigen::VectorXcd z;  ///< u + i v for each vertex, in the units of the mesh
  Parameterization_report report;
};

}  // namespace internal

/// \ingroup PkgParameterization
/// Requires a boundary
void require_boundary(const Mesh_view& mesh, const std::string& function);

namespace internal {

void certify(const Mesh_view& mesh, const Eigen::VectorXcd& z, Parameterization_report& report);

}  // namespace internal

/// \ingroup PkgParameterization
/// \brief Variant of `spectral_parameterization()` that normalizes other curves than whole boundary
/// loops of the mesh.
/// \param loops at least one, the first one with three vertices or more; it is centred at the
/// origin
/// \pre the mesh satisfies the requirements of `spectral_parameterization()`
internal::Parameterization_result spectral_parameterization_of(
    Mesh_view mesh, const std::vector<internal::Vertex_loop>& loops,
    const Parameterization_options& options, const std::string& function);

/// \ingroup PkgParameterization
/// \brief Computes the map to the plane that minimizes the conformal energy for a given variance of
/// the boundary, by an eigenvector [CGP 6.1].
///
/// Minimizes mu = |D psi|^2 / (sum of |z - mean|^2 over the boundary), psi = a - b N. With the
/// normals of the faces this is the spectral conformal parameterization of Mullen et al., a complex
/// Hermitian problem with as many unknowns as vertices. No vertex is pinned, so the result does not
/// depend on such a choice. One factorization and a few solves.
///
/// The longest loop of the image is centred at the origin, its first vertex is on the positive u
/// axis, and the area of the image is that of the surface. The result does not depend on scale and
/// position of the mesh. A surface with holes is mapped to a plane domain with holes; for surfaces
/// with handles there is no such map without flipped faces.
///
/// \throw Precondition_error if the mesh is not a connected, oriented manifold with boundary,
/// finite coordinates and positive areas
/// \throw Solver_error if the energy cannot be factorized. If the iteration does not converge, the
/// report says so.
internal::Parameterization_result spectral_parameterization(
    const Mesh_view& mesh, const Parameterization_options& options = {},
    const std::string& function = "spectral_parameterization");

}  // namespace Conformal_geometry_processing
