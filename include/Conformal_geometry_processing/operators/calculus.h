// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \brief A |F| x |V| quaternionic matrix with three entries per row: an operator that maps values
/// at vertices to values on triangles [CGP 5.1].
///
/// Its pattern is the list of corners of the triangles, fixed at construction; assembly writes to
/// `value(f, c)`, the entry in row f and in the column of corner c. Right-linear: A (x q) = (A x)
/// q.
template <class FT_>
class Quaternionic_sparse_matrix {
 public:
  using FT = FT_;
  using Corners = std::vector<std::array<int, 3>>;

  /// The zero matrix
  /// \param corners the three columns of each row; must outlive the matrix
  /// \param columns the number of columns, greater than every entry of `corners`
  Quaternionic_sparse_matrix(const Corners& corners, int columns)
      : m_corners(&corners), m_columns(columns), m_values(3 * corners.size())
  {}

  int rows() const { return static_cast<int>(m_corners->size()); }
  int cols() const { return m_columns; }

  /// The column of entry c of row f
  int column(int f, int c) const
  {
    return (*m_corners)[static_cast<std::size_t>(f)][static_cast<std::size_t>(c)];
  }

  Quaternion<FT>& value(int f, int c) { return m_values[position(f, c)]; }
  const Quaternion<FT>& value(int f, int c) const { return m_values[position(f, c)]; }

  /// A x: maps |V| to |F| quaternions
  Quaternion_vector<FT> operator*(const Quaternion_vector<FT>& x) const
  {
    Quaternion_vector<FT> y(rows());
    for (int f = 0; f < rows(); ++f)
      for (int c = 0; c < 3; ++c) y[f] += value(f, c) * x[column(f, c)];
    return y;
  }

  /// A^H y, with the conjugate transpose: maps |F| to |V| quaternions
  Quaternion_vector<FT> adjoint_times(const Quaternion_vector<FT>& y) const
  {
    Quaternion_vector<FT> x(cols());
    for (int f = 0; f < rows(); ++f)
      for (int c = 0; c < 3; ++c) x[column(f, c)] += conjugate(value(f, c)) * y[f];
    return x;
  }

  /// The difference of two matrices with the same corners
  friend Quaternionic_sparse_matrix operator-(Quaternionic_sparse_matrix a,
                                              const Quaternionic_sparse_matrix& b)
  {
    for (std::size_t k = 0; k < a.m_values.size(); ++k) a.m_values[k] -= b.m_values[k];
    return a;
  }

 private:
  static std::size_t position(int f, int c)
  {
    return 3 * static_cast<std::size_t>(f) + static_cast<std::size_t>(c);
  }

  const Corners* m_corners;
  int m_columns;
  std::vector<Quaternion<FT>> m_values;
};

}  // namespace internal

/// \ingroup PkgOperators
/// d0: |E| x |V|, the difference along each edge i -> j, i < j; the kernel of a connected mesh
/// consists of the constants [CGP 5.6]
Eigen::SparseMatrix<double, Eigen::RowMajor> exterior_derivative_0(const Mesh_view& mesh);

/// \ingroup PkgOperators
/// d1: |F| x |E|, the circulation around each face; d1 d0 = 0 exactly [CGP 5.6]
Eigen::SparseMatrix<double, Eigen::RowMajor> exterior_derivative_1(const Mesh_view& mesh);

/// \ingroup PkgOperators
/// \brief D: |F| x |V|, the discrete quaternionic Dirac operator [CGP (5.1)].
///
/// (D lambda)_f = -1/(2 A_f) sum_c e_c lambda_c, where e_c is the edge opposite corner c, oriented
/// counter-clockwise. D f = -2 N on every face, constants are in the kernel, and B^H M_F D is
/// Hermitian on a closed surface. In 1/length.
/// \param mesh must outlive the matrix
/// \pre no face has area zero
internal::Quaternionic_sparse_matrix<double> dirac(const Mesh_view& mesh);

/// \ingroup PkgOperators
/// \brief B: |F| x |V|, the mean of the three corners of each face [CGP 5.3]. Dimensionless.
/// \param mesh must outlive the matrix
internal::Quaternionic_sparse_matrix<double> averaging(const Mesh_view& mesh);

/// \ingroup PkgOperators
/// \brief R: |F| x |V|, multiplication by rho [CGP 5.3]; in 1/length.
///
/// R = P B for rho on faces and R = B P for rho on vertices, with P = diag(rho): the latter
/// interpolates the product rho lambda linearly.
/// \param mesh must outlive the matrix
internal::Quaternionic_sparse_matrix<double> potential_matrix(const Mesh_view& mesh,
                                                              const Curvature_potential& rho);

/// \ingroup PkgOperators
/// real numbers as quaternions
Quaternion_vector<double> as_quaternions(const Eigen::VectorXd& numbers);

/// \ingroup PkgOperators
/// vectors of R^3, one per column, as imaginary quaternions
Quaternion_vector<double> as_quaternions(const Points& vectors);

namespace internal {

/// \brief D and the decomposition of its values: the basis of the vector calculus on a surface [CGP
/// 3.3, Table 3.1].
///
/// Functions and vector fields are given at the vertices, where tangent vectors X and normals are
/// vectors of R^3; derivatives live on the faces. A face value is q = a + X + b N with the face
/// normal N. In general
///
///     D(a + X + b N) = -curl X + (J grad a - S X + grad b) + (-div X - 2 H b) N,    J X = N x X
///
/// ([CGP] has + 2 H b). The error of first derivatives is O(h).
class Surface_derivative {
 public:
  /// \param mesh must outlive the object \pre no face has area zero
  explicit Surface_derivative(const Mesh_view& mesh);

  const Mesh_view& mesh() const { return m_mesh; }
  const Quaternionic_sparse_matrix<double>& matrix() const { return m_D; }

  /// N, 3 x |F|
  const Points& normals() const { return m_normals; }

  /// D of a function or of a vector field: |F|
  template <class Field>
  Quaternion_vector<double> operator()(const Field& at_vertices) const
  {
    return m_D * as_quaternions(at_vertices);
  }

  /// \brief D of face values: M_V^-1 D^H M_F q, |V|; applied after D, it gives D^2.
  Quaternion_vector<double> adjoint(Quaternion_vector<double> q) const;

  /// a, |F|
  static Eigen::VectorXd real_part(const Quaternion_vector<double>& q);

  /// b, |F|
  Eigen::VectorXd normal_part(const Quaternion_vector<double>& q) const;

  /// X, 3 x |F|
  Points tangential_part(const Quaternion_vector<double>& q) const;

 private:
  const Mesh_view& m_mesh;
  Quaternionic_sparse_matrix<double> m_D;
  Points m_normals;
  Eigen::VectorXd m_areas;
};

}  // namespace internal

/// \ingroup PkgOperators
/// \brief grad phi = -N D phi, 3 x |F|: exactly the gradient of the function linear on every face.
/// \param phi |V|
Points gradient(const internal::Surface_derivative& d, const Eigen::VectorXd& phi);

/// \ingroup PkgOperators
/// \brief curl X = -Re(D X), |F|: <del_1 X, E_2> - <del_2 X, E_1> in an oriented frame, the
/// circulation per area. ([CGP Table 3.1] has the opposite sign.)
/// \param X tangent vectors at the vertices, 3 x |V|
Eigen::VectorXd curl(const internal::Surface_derivative& d, const Points& X);

/// \ingroup PkgOperators
/// \brief div X = Re(N D X), |F|: the flux out of a small circle, per area.
/// \param X tangent vectors at the vertices, 3 x |V|
Eigen::VectorXd divergence(const internal::Surface_derivative& d, const Points& X);

/// \ingroup PkgOperators
/// \brief Delta phi = Re(D^2 phi) at the vertices, |V|: positive semidefinite, and exactly the
/// cotan Laplacian divided by the vertex areas.
/// \param phi |V|
Eigen::VectorXd laplacian(const internal::Surface_derivative& d, const Eigen::VectorXd& phi);

/// \ingroup PkgOperators
/// \brief the Hodge Laplacian on vector fields, (D (Re DX + (DX)^N))^T at the vertices, 3 x |V|:
/// D^2 X without the contribution of S X. Positive semidefinite.
///
/// [CGP Prop 3.4.9] has only (DX)^N, which gives -grad div X.
/// \param X tangent vectors at the vertices, 3 x |V| \param normals of the vertices, 3 x |V|
Points vector_laplacian(const internal::Surface_derivative& d, const Points& X,
                        const Points& normals);

/// \ingroup PkgOperators
/// \brief the derivative of a function along X, del_X phi = Re(X N D phi) = <X, grad phi>, |F|.
/// \param X tangent vectors on the faces, 3 x |F| \param phi |V|
Eigen::VectorXd covariant_derivative(const internal::Surface_derivative& d, const Points& X,
                                     const Eigen::VectorXd& phi);

/// \ingroup PkgOperators
/// \brief the covariant derivative of a vector field, del_X Y = (dY(X))^T, 3 x |F|: the tangential
/// part of the derivative of its coordinates in R^3 along X.
/// \param X tangent vectors on the faces, 3 x |F| \param Y tangent vectors at the vertices, 3 x |V|
Points covariant_derivative(const internal::Surface_derivative& d, const Points& X,
                            const Points& Y);

/// \ingroup PkgOperators
/// \brief S X = -(D X)^T, 3 x |F|: dN = df S, the identity on the unit sphere with normals outward.
/// \param X tangent vectors at the vertices, 3 x |V|
Points shape_operator(const internal::Surface_derivative& d, const Points& X);

/// \ingroup PkgOperators
/// \brief the first fundamental form, I(X, Y) = -Re(X Y) = <X, Y>: one number for each column.
Eigen::VectorXd first_fundamental_form(const Points& X, const Points& Y);

/// \ingroup PkgOperators
/// \brief the second fundamental form, II(X, Y) = Re(Y D X) = <S X, Y>, |F|: positive on the unit
/// sphere. (Minus the form that [CGP 2.2] defines, whose sign is inconsistent with the rest of it.)
/// \param X tangent vectors at the vertices, 3 x |V| \param Y tangent vectors on the faces, 3 x |F|
Eigen::VectorXd second_fundamental_form(const internal::Surface_derivative& d, const Points& X,
                                        const Points& Y);

/// \ingroup PkgOperators
/// \brief N = -1/2 D f, 3 x |F|: exactly the face normals.
Points dirac_normals(const internal::Surface_derivative& d);

/// \ingroup PkgOperators
/// \brief the mean curvature H = 1/2 N D N = -1/2 <N, D N> on the faces, |F|; +1 on the unit
/// sphere.
///
/// First order, and damps high frequencies as D does. At vertices and for flows, use
/// `mean_curvature()`.
/// \param normals of the surface at its vertices, 3 x |V|
Eigen::VectorXd dirac_mean_curvature(const internal::Surface_derivative& d, const Points& normals);

/// \ingroup PkgOperators
/// \brief the Gauss curvature K = 1/2 <N, Im(D^2) N> at the vertices, |V|, from the imaginary part
/// of D^H M_F D, whose rows sum to zero and which contains only the jumps of the face normals.
///
/// The integral of K is exact for the matrix: second order on regular meshes.
/// \param normals of the surface at its vertices, 3 x |V|
/// \pre the surface is closed
Eigen::VectorXd dirac_gauss_curvature(const internal::Surface_derivative& d, const Points& normals);

}  // namespace Conformal_geometry_processing
