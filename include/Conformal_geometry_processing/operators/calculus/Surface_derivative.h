// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternionic_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// real numbers as quaternions
Quaternion_vector<double> as_quaternions(const Eigen::VectorXd& numbers);

/// \ingroup PkgOperators
/// vectors of R^3, one per column, as imaginary quaternions
Quaternion_vector<double> as_quaternions(const Points& vectors);

namespace internal {

/// \ingroup PkgOperators
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

}  // namespace Conformal_geometry_processing
