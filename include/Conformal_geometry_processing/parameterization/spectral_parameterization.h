// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/overlaps.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/parameterization/cones.h>
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/subspace_iteration.h>

#include <Eigen/Core>

#include <complex>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief Assembles the conformal energy of maps z = a + i b to the plane: z^H L_C z = sum over the
/// faces of area |J grad a - grad b|^2, the Dirichlet energies of a and b minus twice the area of
/// the image.
///
/// It is |D psi|^2 for psi = a - b N without the component of D psi along the normal, where N is
/// the normal of each face [CGP 6.1]. |V| x |V|, complex Hermitian, positive semidefinite: zero for
/// constants, and otherwise only for similarities of flat surfaces. L_C (i z) = i L_C z, so it is
/// invariant under rotations of the image. Its real part is the cotan Laplacian, its imaginary part
/// +-1/2 on the edges of the boundary. Dimensionless.
/// \param pattern `vertex_graph(mesh)`
Hermitian_sparse_matrix<std::complex<double>> conformal_energy(
    const Mesh_view& mesh, std::shared_ptr<const Sparse_pattern> pattern);

/// \ingroup PkgParameterization
/// Assembles the conformal energy with its own pattern
Hermitian_sparse_matrix<std::complex<double>> conformal_energy(const Mesh_view& mesh);

/// \ingroup PkgParameterization
/// \brief Assembles the energy of the thesis for maps z = a + i b: |D psi|^2 of psi = a - b N
/// without the component along the normals of the faces, where N is a normal of each *vertex*
/// [CGP 6.1].
///
/// sum over the faces k of area |J grad a - sum_j b_j <N_j, N_k> grad phi_j|^2: it differs from
/// `conformal_energy()` by the cosines <N_j, N_k>, which tend to 1 under refinement of smooth
/// surfaces. Otherwise the energy does not measure conformality: it does not vanish for constant b
/// and is not invariant under rotations of the image, so maps of scans are much worse. (The thesis
/// has a + b N, which gives the conjugate of the map.)
///
/// Real, 2|V| x 2|V| on `expanded_pattern(graph, 2)`, rows a_i, b_i; positive semidefinite.
/// \param normals 3 x |V|, of unit length \param graph `vertex_graph(mesh)`
Hermitian_sparse_matrix<double> vertex_normal_energy(const Mesh_view& mesh, const Points& normals,
                                                     const Sparse_pattern& graph);

/// \ingroup PkgParameterization
/// \brief Quality measures of a parameterization.
///
/// If a surface is far from flat, faces may be flipped, or distant parts of the image may overlap:
/// `conformality.flipped_faces` counts the former, `overlap` the latter.
struct [[nodiscard]] Parameterization_report {
  bool converged = false;  ///< the eigenvector has converged to the tolerance
  double eigenvalue = 0;   ///< minimal energy over the variance of the boundary; 0 if it is flat
  double next_eigenvalue = 0;  ///< of the next map that is not a rotated image of this one
  double residual = 0;         ///< relative error estimate of the map in the norm of the energy
  int iterations = 0;
  int boundary_loops = 0;
  int normalized_vertices = 0;  ///< number of boundary vertices in the normalization

  Conformality conformality;                       ///< of the map from the surface to the plane
  internal::Distribution uniform_quasi_conformal;  ///< of Q, with equal weights of all faces
  internal::Overlap_summary overlap;               ///< of the image with itself

  /// Wall clock seconds
  struct Seconds {
    double setup = 0;  ///< pattern, ordering, symbolic analysis
    double assembly = 0, factorization = 0, eigenvector = 0, certificate = 0;
    double total() const { return setup + assembly + factorization + eigenvector + certificate; }
  } seconds;

  /// Returns whether a map was found; it may have flipped faces
  explicit operator bool() const { return converged; }
};

/// \relates Parameterization_report
/// Prints the report, one fact per line
std::ostream& operator<<(std::ostream& out, const Parameterization_report& r);

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
  /// edges whose images are to differ by given similarities; of faces' normals
  std::vector<internal::Seam> seams = {};
};

namespace internal {

/// A map to the plane and its quality measures
struct Parameterization_result {
  Eigen::VectorXcd z;  ///< u + i v for each vertex, in the units of the mesh
  Parameterization_report report;
};

void certify(const Mesh_view& mesh, const Eigen::VectorXcd& z, Parameterization_report& report);

}  // namespace internal

/// \ingroup PkgParameterization
/// Requires a boundary
void require_boundary(const Mesh_view& mesh, const std::string& function);

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
