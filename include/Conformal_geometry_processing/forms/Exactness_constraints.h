// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_EXACTNESS_CONSTRAINTS_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_EXACTNESS_CONSTRAINTS_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/forms/tangent_field.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// how the constraints of exactness are discretised
enum class Exactness {
  adjoint,  ///< the derivative of what the program computes: the error left is of second order
  thesis    ///< solutions of D Z = v [CGP 6.4.5], least squares: leaves a first-order error O(h^2)
};

namespace internal {

/// D^H D Y = c: half the sum of w omega e over the edges e at each vertex, for each form
template <class Surface>
Block<Quaternion<double>> adjoint_sources(const Surface& mesh, const Harmonic_basis& basis)
{
  const Eigen::VectorXd w = cotan_weights(mesh);
  Block<Quaternion<double>> c = Block<Quaternion<double>>::Constant(
      mesh.size_of_vertices(), basis.size(), Quaternion<double>{});
  for (int i = 0; i < basis.size(); ++i)
    for (int k = 0; k < mesh.size_of_edges(); ++k) {
      const Eigen::Vector3d e = mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0]);
      const Quaternion<double> share = imaginary(w[k] * basis.one_forms(k, i) / 2 * e);
      for (int v : mesh.ends(k)) c(v, i) += share;
    }
  return c;
}

/// a column for each column of sources and each axis of space
Block<Quaternion<double>> sources_along_axes(const Block<Quaternion<double>>& sources);

/// the same for D Z = v in the sense of least squares: D^H M_F v
Block<Quaternion<double>> field_sources(const Mesh_view& mesh, const Harmonic_basis& basis);

/// the imaginary parts, n x 3
Eigen::MatrixX3d imaginary_columns(const Quaternion_vector<double>& z);

/// the mean of the corners of each face, |F| x k
Eigen::MatrixXd face_means(const Mesh_view& mesh, const Eigen::MatrixXd& values);

/// M_V^-1 B^T M_F: the mean of the faces around each vertex, weighted by area, |V| x k
Eigen::MatrixXd vertex_means(const Mesh_view& mesh, const Eigen::MatrixXd& values);

}  // namespace internal

/// \ingroup PkgForms
/// \brief the functions z to which rho must be orthogonal so that the spin transformed surface
/// closes up to first order: 6G columns, three for each harmonic form [CGP 4.5.2, 6.4.5].
///
/// For small rho the solution of (D - rho) lambda = gamma lambda is 1 + Y with D^H D Y = D^H rho,
/// and the harmonic part of the new edges is, to first order, twice the inner products of rho and
/// z in the basis of forms and the axes of space: sum_i M_V,i rho_i z_i for rho on vertices, with
/// areas of faces for rho on faces. On isothermic surfaces, such as tori of revolution, only 6G - 1
/// of the functions are independent.
///
/// One solve for each form.
/// \param inverse a callable `Block<Quaternion<double>>` -> the same that solves with D^H M_F D:
/// a `Dirac_energy_solver` or a `Dirac_energy_inverse`
/// \param on where rho lives
/// \returns |V| x 6G or |F| x 6G; column 3 i + a belongs to form i and axis a
template <class Inverse>
Eigen::MatrixXd exactness_constraints(const Mesh_view& mesh, const Harmonic_basis& basis,
                                      const Inverse& inverse, Curvature_potential::On on,
                                      Exactness version = Exactness::adjoint)
{
  const bool is_adjoint = version == Exactness::adjoint;
  const bool on_vertices = on == Curvature_potential::On::vertices;
  const Block<Quaternion<double>> Y = inverse(is_adjoint ? internal::adjoint_sources(mesh, basis)
                                                         : internal::field_sources(mesh, basis));
  const Quaternionic_sparse_matrix<double> D = dirac(mesh);
  Eigen::MatrixXd z(on_vertices ? mesh.size_of_vertices() : mesh.size_of_faces(), 3 * basis.size());
  for (int i = 0; i < basis.size(); ++i) {
    const Quaternion_vector<double> y = Y.col(i);
    // D y lives on faces, the solution of D y = v on vertices.
    const Eigen::MatrixX3d own = internal::imaginary_columns(is_adjoint ? D * y : y);
    if (is_adjoint == on_vertices)
      z.middleCols<3>(3 * i) =
          on_vertices ? internal::vertex_means(mesh, own) : internal::face_means(mesh, own);
    else
      z.middleCols<3>(3 * i) = own;
  }
  return z;
}

/// \ingroup PkgForms
/// \brief the same functions on a surface with boundary, 3 for each harmonic form, as
/// `Exactness::adjoint` has them.
///
/// With directions prescribed at the boundary the spins are a space over the real numbers only, so
/// that each axis of space needs a solve of its own. [CGP 6.4.5], D Z = v, is no derivative of the
/// periods there and leaves them of first order.
/// \param basis of Neumann type, as `Hodge_decomposition` gives it
/// \param inverse a callable `Block<Quaternion<double>>` -> the same: the change of lambda that
/// answers to sources c, (D^H M_F D) y = c in the space that the boundary condition allows
template <class Inverse>
Eigen::MatrixXd bounded_exactness_constraints(const Mesh_view& mesh, const Harmonic_basis& basis,
                                              const Inverse& inverse, Curvature_potential::On on)
{
  const Block<Quaternion<double>> c =
      internal::sources_along_axes(internal::adjoint_sources(mesh, basis));
  const Block<Quaternion<double>> Y = inverse(c);
  const Quaternionic_sparse_matrix<double> D = dirac(mesh);
  Eigen::MatrixXd z(mesh.size_of_faces(), c.cols());
  for (Eigen::Index i = 0; i < c.cols(); ++i)
    z.col(i) = components(Quaternion_vector<double>(D * Quaternion_vector<double>(Y.col(i))))
                   .row(0)
                   .transpose();
  return on == Curvature_potential::On::vertices ? internal::vertex_means(mesh, z) : z;
}

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/forms/Exactness_constraints_impl.h>
#endif

#endif
