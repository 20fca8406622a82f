// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace Conformal_geometry_processing::internal {

/// \brief products with the forms of a `Harmonic_basis`, written as G T - d0 u with closed
/// generators G.
///
/// There are a third as many vertices as edges, and the generators have few numbers: around
/// hundreds of holes, this costs a third of the time and the memory of the forms.
class Harmonic_part {
 public:
  /// \param surface must outlive the object
  /// \param w `cotan_weights(surface)`
  /// \param generators G, |E| x size \param combinations T, size x size
  /// \param potentials u, |V| x size
  Harmonic_part(const Surface_ref& surface, Eigen::VectorXd w,
                Eigen::SparseMatrix<double> generators, Eigen::MatrixXd combinations,
                Eigen::MatrixXd potentials);

  int size() const { return static_cast<int>(m_potentials.cols()); }

  const Eigen::MatrixXd& generator_combinations() const { return m_combinations; }  ///< T
  const Eigen::MatrixXd& potentials() const { return m_potentials; }                ///< u

  /// \brief <omega_i, alpha> for the forms omega_i of the basis and the columns alpha: `size()` x
  /// k.
  ///
  /// The harmonic part of alpha is `combinations(coefficients(alpha))`; its squared norm is the sum
  /// of the squared coefficients.
  /// \param alpha |E| x k
  Eigen::MatrixXd coefficients(const Eigen::MatrixXd& alpha) const;

  /// sums of the forms with coefficients c, `size()` x k: |E| x k
  Eigen::MatrixXd combinations(const Eigen::MatrixXd& c) const;

  /// all of the forms, |E| x `size()`
  Eigen::MatrixXd one_forms() const
  {
    return combinations(Eigen::MatrixXd::Identity(size(), size()));
  }

 private:
  Surface_ref m_surface;
  Eigen::VectorXd m_weights;                 // |E|
  Eigen::SparseMatrix<double> m_generators;  // G
  Eigen::MatrixXd m_combinations;            // T
  Eigen::MatrixXd m_potentials;              // u
};

}  // namespace Conformal_geometry_processing::internal
