// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Conformal_geometry_processing::internal {

/// \brief finds the shift that is the quotient of its own eigenvector: the zero of the change from
/// a shift to that quotient, by the secant method.
///
/// The derivative of the change is nearly -1 on fine meshes, where the eigenvector hardly depends
/// on the shift, and nearer to zero the coarser the mesh.
class Shift_secant {
 public:
  /// forgets the last change, but not the derivative: for another vector near by
  void restart() { m_change = std::numeric_limits<double>::infinity(); }

  /// whether a change is smaller than the last one
  bool is_nearer(double change) const { return std::abs(change) < std::abs(m_change); }

  /// \brief the step from a shift to the zero.
  /// \param error of the change: those that differ by less say nothing about the derivative
  double step(double shift, double change, double error)
  {
    const double steepest = -2, flattest = -0.05;
    if (std::isfinite(m_change) && shift != m_shift && std::abs(change - m_change) > error)
      m_slope = std::clamp((change - m_change) / (shift - m_shift), steepest, flattest);
    m_shift = shift;
    m_change = change;
    return -change / m_slope;
  }

 private:
  double m_shift = 0, m_slope = -1;
  double m_change =
      std::numeric_limits<double>::infinity();  // at m_shift; infinite before the first
};

/// \brief the forms of D - base - t rho - sigma on the span of k vectors V, |V| x k, for every t
/// and sigma; base is 0 where none is given.
///
/// They are combinations of the inner products of the images (D - base) V, R V and B V on the
/// faces, in the norm of M_F: 3 k x 3 k numbers, with which following a branch in t costs nothing
/// that depends on the size of the mesh.
class Dirac_gram {
 public:
  /// of no vectors
  Dirac_gram() = default;

  Dirac_gram(const Surface_ref& surface, const Curvature_potential& rho,
             const Block<Quaternion<double>>& vectors)
  {
    extend(surface, rho, vectors);
  }

  Dirac_gram(const Surface_ref& surface, const Curvature_potential& base,
             const Curvature_potential& rho, const Block<Quaternion<double>>& vectors)
  {
    extend(surface, base, rho, vectors);
  }

  /// \brief adds the last columns of V; the first ones are the present vectors.
  ///
  /// O(k sheets) for each new vector, without assembling a matrix
  void extend(const Surface_ref& surface, const Curvature_potential& rho,
              const Block<Quaternion<double>>& vectors)
  {
    extend(surface, no_potential(surface), rho, vectors);
  }

  /// keeps the first vector and the last `count` others
  void forget_all_but(Eigen::Index count);

  /// the forms on the span without its last vector
  Dirac_gram without_last() const;

  Eigen::Index size_of_vectors() const { return m_products.cols() / images; }

  /// V^H X V for the energy X of t rho + sigma, k x k: Hermitian, positive semidefinite
  Block<Quaternion<double>> energy(double t, double sigma) const;

  /// \brief `dirac_quotient()` of D - t rho at V c, in 1/length.
  /// \param c k coefficients, not zero
  double quotient(double t, const Quaternion_vector<double>& c) const;

 private:
  enum Image : Eigen::Index { dirac, potential, average, images };

  void extend(const Surface_ref& surface, const Curvature_potential& base,
              const Curvature_potential& rho, const Block<Quaternion<double>>& vectors);

  /// c^H <image a, image b> c
  Quaternion<double> form(Image a, Image b, const Quaternion_vector<double>& c) const;

  Block<Quaternion<double>> m_products;  // of D v_1, R v_1, B v_1, D v_2, ... in M_F
};

/// \brief a point on a branch of eigenpairs of D - t rho, within the span of some vectors.
struct Branch_point {
  double t = 0;
  double gamma = 0;             ///< the eigenvalue, in 1/length
  Quaternion_vector<double> c;  ///< coefficients of the eigenvector, of norm one
  double misfit = 0;            ///< |(D - t rho - gamma) V c|, in 1/length
  /// distance of gamma to the next eigenvalue in the span, and the least on the way to this point
  double gap = std::numeric_limits<double>::infinity();
  double least_gap = std::numeric_limits<double>::infinity();
  bool is_settled = false;  ///< found by `follow_settled_branch()`
};

/// \brief follows a branch from a point to `end`, or as far as its vector overlaps with the first
/// one by `least_overlap`.
///
/// Each step takes the smallest eigenvectors of the energy of t rho + sigma, with sigma the
/// eigenvalue itself, hence D - t rho - sigma, whose square is the energy, has it at zero, and
/// cannot mix it with eigenvectors of opposite sign. The signed form alone would not do: it is
/// indefinite, and a projection of it has eigenvalues that belong to no vector.
///
/// Steps are at least 1/24 long: two branches that cross are coupled a little by errors of the span
/// or the mesh, and shorter steps would turn off at every crossing.
/// \pre the vectors of `gram` are orthonormal with respect to the vertex areas
Branch_point follow_branch(const Dirac_gram& gram, const Branch_point& first, double end,
                           double least_overlap);

/// \brief follows a branch from a point to `end`, or as far as the span is found to contain it,
/// however much its vector turns on the way.
///
/// Three conditions hold after every eighth of the way from t = 0 to 1:
/// 1. The span without its last vector leads to the same vector: the approximation has settled.
/// 2. The vector has turned little since the eighth before: no other branch comes near, with which
///    errors of the span would mix it.
/// 3. Its misfit is at most half of the gap, which bounds the sine of its error.
Branch_point follow_settled_branch(const Dirac_gram& gram, const Branch_point& first, double end);

}  // namespace Conformal_geometry_processing::internal
