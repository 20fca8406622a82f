// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_EXACTNESS_CONSTRAINTS_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_EXACTNESS_CONSTRAINTS_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/forms/Exactness_constraints.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE Block<Quaternion<double>> sources_along_axes(const Block<Quaternion<double>>& sources)
{
  const std::array<Quaternion<double>, 3> axes = {{{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  Block<Quaternion<double>> c(sources.rows(), 3 * sources.cols());
  for (Eigen::Index i = 0; i < c.cols(); ++i)
    for (Eigen::Index v = 0; v < c.rows(); ++v)
      c(v, i) = sources(v, i / 3) * conjugate(axes[static_cast<std::size_t>(i % 3)]);
  return c;
}

CGP_INLINE Block<Quaternion<double>> field_sources(const Mesh_view& mesh,
                                                   const Harmonic_basis& basis)
{
  const Quaternionic_sparse_matrix<double> D = dirac(mesh);
  const Eigen::VectorXd areas = face_areas(mesh);
  Block<Quaternion<double>> c(mesh.size_of_vertices(), basis.size());
  Quaternion_vector<double> Av(mesh.size_of_faces());
  for (int i = 0; i < basis.size(); ++i) {
    const Points& v = basis.fields[static_cast<std::size_t>(i)];
    for (int f = 0; f < mesh.size_of_faces(); ++f) Av[f] = imaginary(areas[f] * v.col(f));
    c.col(i) = D.adjoint_times(Av);
  }
  return c;
}

CGP_INLINE Eigen::MatrixX3d imaginary_columns(const Quaternion_vector<double>& z)
{
  return components(z).bottomRows<3>().transpose();
}

CGP_INLINE Eigen::MatrixXd face_means(const Mesh_view& mesh, const Eigen::MatrixXd& values)
{
  Eigen::MatrixXd means(mesh.size_of_faces(), values.cols());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    means.row(f) = (values.row(v[0]) + values.row(v[1]) + values.row(v[2])) / 3;
  }
  return means;
}

CGP_INLINE Eigen::MatrixXd vertex_means(const Mesh_view& mesh, const Eigen::MatrixXd& values)
{
  const Eigen::VectorXd areas = face_areas(mesh);
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(mesh.size_of_vertices(), values.cols());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) means.row(v) += areas[f] / 3 * values.row(f);
  means.array().colwise() /= vertex_areas(mesh).array();
  return means;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
