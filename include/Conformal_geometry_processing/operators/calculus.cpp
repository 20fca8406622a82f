// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

namespace Conformal_geometry_processing {

Eigen::SparseMatrix<double, Eigen::RowMajor> exterior_derivative_0(const Mesh_view& mesh)
{
  Eigen::SparseMatrix<double, Eigen::RowMajor> d(mesh.size_of_edges(), mesh.size_of_vertices());
  d.reserve(Eigen::VectorXi::Constant(mesh.size_of_edges(), 2));
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    d.insert(k, mesh.ends(k)[0]) = -1;
    d.insert(k, mesh.ends(k)[1]) = 1;
  }
  d.makeCompressed();
  return d;
}

Eigen::SparseMatrix<double, Eigen::RowMajor> exterior_derivative_1(const Mesh_view& mesh)
{
  Eigen::SparseMatrix<double, Eigen::RowMajor> d(mesh.size_of_faces(), mesh.size_of_edges());
  d.reserve(Eigen::VectorXi::Constant(mesh.size_of_faces(), 3));
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    d.insert(Mesh_view::face(h), mesh.edge(h)) = mesh.from(h) < mesh.to(h) ? 1 : -1;
  d.makeCompressed();
  return d;
}

internal::Quaternionic_sparse_matrix<double> dirac(const Mesh_view& mesh)
{
  internal::Quaternionic_sparse_matrix<double> D(mesh.corners(), mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double double_area = mesh.double_area_vector(f).norm();
    for (int c = 0; c < 3; ++c) D.value(f, c) = imaginary(mesh.vector(3 * f + c)) / -double_area;
  }
  return D;
}

internal::Quaternionic_sparse_matrix<double> averaging(const Mesh_view& mesh)
{
  internal::Quaternionic_sparse_matrix<double> B(mesh.corners(), mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int c = 0; c < 3; ++c) B.value(f, c) = {1. / 3, 0, 0, 0};
  return B;
}

internal::Quaternionic_sparse_matrix<double> potential_matrix(const Mesh_view& mesh,
                                                              const Curvature_potential& rho)
{
  internal::Quaternionic_sparse_matrix<double> R(mesh.corners(), mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const Eigen::Vector3d r = rho.at_corners(mesh.sheet(f));
    for (int c = 0; c < 3; ++c) R.value(f, c) = {r[c] / 3, 0, 0, 0};
  }
  return R;
}

Quaternion_vector<double> as_quaternions(const Eigen::VectorXd& numbers)
{
  Quaternion_vector<double> q(numbers.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = {numbers[i], 0, 0, 0};
  return q;
}

Quaternion_vector<double> as_quaternions(const Points& vectors)
{
  Quaternion_vector<double> q(vectors.cols());
  for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = imaginary(vectors.col(i));
  return q;
}

internal::Surface_derivative::Surface_derivative(const Mesh_view& mesh)
    : m_mesh(mesh), m_D(dirac(mesh)), m_normals(face_normals(mesh)), m_areas(face_areas(mesh))
{}

Quaternion_vector<double> internal::Surface_derivative::adjoint(Quaternion_vector<double> q) const
{
  for (Eigen::Index f = 0; f < q.size(); ++f) q[f] *= m_areas[f];
  Quaternion_vector<double> p = m_D.adjoint_times(q);
  const Eigen::VectorXd areas = vertex_areas(m_mesh);
  for (Eigen::Index v = 0; v < p.size(); ++v) p[v] *= 1 / areas[v];
  return p;
}

Eigen::VectorXd internal::Surface_derivative::real_part(const Quaternion_vector<double>& q)
{
  return components(q).row(0).transpose();
}

Eigen::VectorXd internal::Surface_derivative::normal_part(const Quaternion_vector<double>& q) const
{
  return components(q).bottomRows<3>().cwiseProduct(m_normals).colwise().sum().transpose();
}

Points internal::Surface_derivative::tangential_part(const Quaternion_vector<double>& q) const
{
  return components(q).bottomRows<3>() - m_normals * normal_part(q).asDiagonal();
}

Points gradient(const internal::Surface_derivative& d, const Eigen::VectorXd& phi)
{
  Quaternion_vector<double> q = d(phi);
  for (Eigen::Index f = 0; f < q.size(); ++f) q[f] = -imaginary(d.normals().col(f)) * q[f];
  return d.tangential_part(q);
}

Eigen::VectorXd curl(const internal::Surface_derivative& d, const Points& X)
{
  return -d.real_part(d(X));
}

Eigen::VectorXd divergence(const internal::Surface_derivative& d, const Points& X)
{
  return -d.normal_part(d(X));
}

Eigen::VectorXd laplacian(const internal::Surface_derivative& d, const Eigen::VectorXd& phi)
{
  return d.real_part(d.adjoint(d(phi)));
}

Points vector_laplacian(const internal::Surface_derivative& d, const Points& X,
                        const Points& normals)
{
  Quaternion_vector<double> q = d(X);
  components(q).bottomRows<3>() -= d.tangential_part(q);
  const Quaternion_vector<double> p = d.adjoint(q);
  const Points image = components(p).bottomRows<3>();
  const Eigen::VectorXd along = image.cwiseProduct(normals).colwise().sum().transpose();
  return image - normals * along.asDiagonal();
}

Eigen::VectorXd covariant_derivative(const internal::Surface_derivative& d, const Points& X,
                                     const Eigen::VectorXd& phi)
{
  const Quaternion_vector<double> q = d(phi);
  Eigen::VectorXd derivative(q.size());
  for (Eigen::Index f = 0; f < q.size(); ++f)
    derivative[f] = (imaginary(X.col(f)) * imaginary(d.normals().col(f)) * q[f]).w;
  return derivative;
}

Points covariant_derivative(const internal::Surface_derivative& d, const Points& X, const Points& Y)
{
  Points derivative(3, X.cols());
  for (Eigen::Index c = 0; c < 3; ++c)
    derivative.row(c) =
        covariant_derivative(d, X, Eigen::VectorXd(Y.row(c).transpose())).transpose();
  return d.tangential_part(as_quaternions(derivative));
}

Points shape_operator(const internal::Surface_derivative& d, const Points& X)
{
  return -d.tangential_part(d(X));
}

Eigen::VectorXd first_fundamental_form(const Points& X, const Points& Y)
{
  return X.cwiseProduct(Y).colwise().sum().transpose();
}

Eigen::VectorXd second_fundamental_form(const internal::Surface_derivative& d, const Points& X,
                                        const Points& Y)
{
  return first_fundamental_form(shape_operator(d, X), Y);
}

Points dirac_normals(const internal::Surface_derivative& d)
{
  return -components(d(d.mesh().positions())).bottomRows<3>() / 2;
}

Eigen::VectorXd dirac_mean_curvature(const internal::Surface_derivative& d, const Points& normals)
{
  return -d.normal_part(d(normals)) / 2;
}

Eigen::VectorXd dirac_gauss_curvature(const internal::Surface_derivative& d, const Points& normals)
{
  const auto X = dirac_energy(d.mesh(), no_potential(d.mesh()));
  const Eigen::VectorXd areas = vertex_areas(d.mesh());
  Quaternion_vector<double> image(areas.size());
  X.for_each_entry([&](int i, int j, Quaternion<double> x) {
    x.w = 0;
    image[i] += x * imaginary(normals.col(j));
    if (i != j) image[j] += conjugate(x) * imaginary(normals.col(i));
  });
  Eigen::VectorXd K(areas.size());
  for (Eigen::Index v = 0; v < K.size(); ++v)
    K[v] = normals.col(v).dot(imaginary_part(image[v])) / (2 * areas[v]);
  return K;
}

}  // namespace Conformal_geometry_processing
