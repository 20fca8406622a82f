// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

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

/// the parts of k 1-forms: they sum up to the forms and are pairwise orthogonal
struct Hodge_parts {
  Eigen::MatrixXd potential;  ///< |V| x k: u with exact = d0 u and mean zero
  Eigen::MatrixXd exact;      ///< |E| x k
  Eigen::MatrixXd coexact;    ///< |E| x k
  Eigen::MatrixXd harmonic;   ///< |E| x k
};

}  // namespace internal

/// \ingroup PkgForms
/// \brief splits 1-forms of a surface into exact, co-exact and harmonic parts, and computes a basis
/// of the harmonic forms [CGP 6.4.5].
///
/// At a boundary, co-exact and harmonic fields are tangent to it (Neumann conditions), and the
/// functions of exact ones are free.
///
/// Orthogonality means sum_e w_e a_e b_e = 0 with cotan weights w, which may be negative. The
/// method does not divide by weights, so right angles are harmless: the exact part is d0 u with L u
/// = d0^T w omega, the basis determines the harmonic part, and the rest is co-exact. The basis is
/// computed in the same way from closed generators eta: omega = eta - d0 u.
///
/// Factors the Laplacian once, unless its factor is given; the basis costs two solves with it per
/// form.
///
class Hodge_decomposition {
 public:
  /// \param mesh must outlive the object
  /// \param function named in exceptions
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with finite
  /// coordinates and positive areas; the message names the first offending element
  /// \throw Solver_error if the Laplacian cannot be factored
  explicit Hodge_decomposition(const Mesh_view& mesh,
                               const std::string& function = "Hodge_decomposition",
                               const Spin_solvers& solvers = {});

  /// \brief from given generators, with a given factor.
  /// \param generators closed forms, |E| x their number (see `closed_generators()`), no linear
  /// combination of which is exact
  /// \param surface must outlive the object
  /// \param laplacian solves with the Laplacian of the surface, like
  /// `Poisson_reconstruction::solver()`; must outlive the object
  /// \param start the forms by these generators of a surface of the same connectivity, or null:
  /// from those of one nearby, a single solve per form is enough
  /// \pre `require_surface(mesh)` holds
  /// \throw Precondition_error if the generators are not independent
  Hodge_decomposition(const Surface_ref& surface, Eigen::MatrixXd generators,
                      const internal::Grounded_solver& laplacian,
                      const internal::Harmonic_part* start = nullptr);

  const Harmonic_basis& harmonic_basis() const& { return m_basis; }
  Harmonic_basis harmonic_basis() && { return std::move(m_basis); }

  /// products with the forms of the basis
  const internal::Harmonic_part& harmonic_part() const { return *m_part; }

  /// `cotan_weights(surface)`: the inner product of 1-forms, |E|
  const Eigen::VectorXd& weights() const { return m_weights; }

  /// \param omega |E| x k, along each edge i -> j, i < j
  /// \throw Solver_error if the solver fails
  internal::Hodge_parts decompose(const Eigen::MatrixXd& omega) const;

 private:
  using Laplacian = std::shared_ptr<const internal::Grounded_solver>;

  // A checked mesh; the checks must precede all other members.
  struct Checked_mesh {
    Checked_mesh(const Mesh_view& mesh_, const std::string& function);
    const Mesh_view& mesh;
  };

  Hodge_decomposition(const Checked_mesh& c, const Spin_solvers& solvers);
  Hodge_decomposition(const Surface_ref& surface, Eigen::MatrixXd generators, Laplacian laplacian,
                      const internal::Harmonic_part* start);
  static Laplacian factored(const Mesh_view& mesh, const Spin_solvers& solvers);
  static Laplacian not_owned(const internal::Grounded_solver& laplacian);

  /// u with L u = d0^T w omega
  Eigen::MatrixXd potential(const Eigen::MatrixXd& omega) const;

  Surface_ref m_surface;
  Eigen::VectorXd m_weights;  // |E|
  Laplacian m_laplacian;
  Harmonic_basis m_basis;
  std::optional<internal::Harmonic_part> m_part;
};

}  // namespace Conformal_geometry_processing
