// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_PENCIL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_PENCIL_H

#include <Conformal_geometry_processing/algebra/random_quaternions.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Krylov_space.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Reduced_hermitian_solver.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Prescribed_directions.h>
#include <Conformal_geometry_processing/spin/constant_spins.h>
#include <Conformal_geometry_processing/spin/gauge.h>

#include <Eigen/Core>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the Hermitian forms of D - rho on the spins of a surface, and the inverse of its energy:
/// X = A^H M_F A, the Hermitian part of B^H M_F A, and M_V, with A = D - R.
///
/// With a condition at the boundary all of them are restricted to the spins that fulfil it. Where
/// rho = 0 the constants in the space are in the kernel of the first two; they are left out then.
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class SolverTraits>
class Dirac_pencil {
 public:
  using Vectors = Block<Quaternion<double>>;

  /// \param mesh must outlive the object
  /// \param condition of directions, or none on a closed surface
  /// \pre `require_surface(mesh)` and `require_condition(mesh, condition)` hold
  /// \throw Solver_error if the analysis fails
  Dirac_pencil(const Mesh_view& mesh, const Boundary_condition& condition,
               const std::string& function)
      : m_function(function), m_mesh(mesh), m_areas(vertex_areas(mesh)), m_X(vertex_graph(mesh))
  {
    check("analysis", m_solver.analyze_with_positions(m_X.pattern(), m_mesh.positions()));
    if (condition.kind != Boundary_condition::Kind::directions) return;
    m_directions = std::make_unique<Prescribed_directions<SolverTraits>>(
        m_mesh, condition, m_X.shared_pattern(), m_solver);
    check("analysis",
          m_reduced.analyze_with_positions(m_X.pattern(), basis().rows(), m_mesh.positions()));
  }

  Dirac_pencil(const Dirac_pencil&) = delete;
  Dirac_pencil& operator=(const Dirac_pencil&) = delete;

  /// \brief assembles and factors X.
  /// \throw Solver_error if that fails
  void set_potential(Curvature_potential rho)
  {
    m_rho = std::move(rho);
    const double negligible = 1e-12 * std::sqrt(unit());
    const bool is_zero = m_rho.values.cwiseAbs().maxCoeff() <= negligible;
    m_constants = is_zero ? find_constants() : Vectors(m_areas.size(), 0);
    factorize();
  }

  /// the spins in the kernel of A that are left out, orthonormal with M_V
  const Vectors& constants() const { return m_constants; }

  /// over which numbers the spins are a space
  Coefficients coefficients() const
  {
    return m_directions ? Coefficients::reals : Coefficients::quaternions;
  }

  /// K = B^H M_F A, N = X with a diagonal shift that keeps it definite; refers to the object
  Pencil of_form() const
  {
    Pencil pencil = of_masses();
    pencil.K = [this](const Vectors& v) { return apply_form(v); };
    return pencil;
  }

  /// K = M_V, and N as before
  Pencil of_masses() const
  {
    Pencil pencil;
    pencil.coefficients = coefficients();
    pencil.K = [this](const Vectors& v) { return projected(block_operator(m_areas)(v)); };
    pencil.N = [this](const Vectors& v) { return apply_energy(v); };
    pencil.solve = [this](const Vectors& b) { return solve(b); };
    return pencil;
  }

  /// X^-1 of noise
  Vectors noise(Eigen::Index columns, unsigned seed) const
  {
    return solve(block_operator(m_areas)(random_quaternions(m_areas.size(), columns, seed)));
  }

  /// <v, X v>
  double energy(const Quaternion_vector<double>& v) const { return inner_product(v, m_X * v).w; }

  /// <v, M_V v>
  double squared_norm(const Quaternion_vector<double>& v) const
  {
    return inner_product(v, m_areas, v).w;
  }

  /// A^H M_V B
  Vectors products(const Vectors& a, const Vectors& b) const
  {
    return gram_matrix(a, block_operator(m_areas)(b), coefficients());
  }

  /// over the numbers of `coefficients()`
  Dirac_forms forms(const Vectors& v) const
  {
    Dirac_forms forms = dirac_forms(m_mesh, m_rho, v);
    for (Vectors* form : {&forms.dirac, &forms.mass})
      for (Eigen::Index k = 0; k < form->size(); ++k)
        form->data()[k] = reduced_to(coefficients(), form->data()[k]);
    return forms;
  }

  /// the mean of |lambda|^2 becomes one; over the quaternions see `fix_gauge()`
  Quaternion_vector<double> normalized(Quaternion_vector<double> lambda) const
  {
    if (!m_directions)
      fix_gauge(lambda, m_areas);
    else
      components(lambda) *= std::sqrt(m_areas.sum() / squared_norm(lambda));
    return lambda;
  }

 private:
  void check(const char* step, Solver_status status) const
  {
    if (status != Solver_status::success)
      throw Solver_error(m_function, std::string(step) + " of X failed: " + to_string(status));
  }

  /// 4 pi / area: the size of the low eigenvalues of X
  double unit() const
  {
    const double pi = std::acos(-1.);
    return 4 * pi / m_areas.sum();
  }

  const Reduced_basis<double>& basis() const { return m_directions->basis(); }

  Vectors projected(Vectors v) const { return m_directions ? basis().project(std::move(v)) : v; }

  /// the kernel of D in the space, orthonormal with M_V
  Vectors find_constants() const
  {
    Vector<Quaternion<double>> spins =
        Vector<Quaternion<double>>::Constant(1, Quaternion<double>{1, 0, 0, 0});
    if (m_directions) spins = constant_spins(basis());
    Vectors v(m_areas.size(), spins.size());
    for (Eigen::Index c = 0; c < v.cols(); ++c)
      v.col(c).setConstant(spins[c] / std::sqrt(m_areas.sum()));
    return v;
  }

  /// X with a shift of its diagonal that makes it definite, where the constants are in its kernel
  void factorize()
  {
    assemble_dirac_energy(m_mesh, m_rho, m_X);
    Solver_status status = Solver_status::not_positive_definite;
    for (const double share : {1e-9, 1e-6, 1e-3}) {  // slivers need more than others
      if (status != Solver_status::not_positive_definite) break;
      m_regularization = share * unit();
      const Eigen::VectorXd shift = m_regularization * m_areas;
      status =
          m_directions ? m_reduced.factorize(m_X, shift, basis()) : m_solver.factorize(m_X, shift);
    }
    check("factorization", status);
  }

  Vectors apply_form(const Vectors& v) const
  {
    Vectors w(v.rows(), v.cols());
    for (Eigen::Index c = 0; c < v.cols(); ++c)
      w.col(c) = apply_dirac_form(m_mesh, m_rho, v.col(c));
    return projected(std::move(w));
  }

  Vectors apply_energy(const Vectors& v) const
  {
    Vectors w = block_operator(m_X)(v);
    for (Eigen::Index c = 0; c < v.cols(); ++c)
      for (Eigen::Index i = 0; i < v.rows(); ++i)
        w(i, c) += (m_regularization * m_areas[i]) * v(i, c);
    return projected(std::move(w));
  }

  Vectors solve(Vectors b) const
  {
    // What is there of the constants is rounding, which the factor would blow up.
    const Vectors masses = block_operator(m_areas)(m_constants);
    add_combination(b, masses, Vectors(-gram_matrix(m_constants, b, coefficients())));
    Vectors x;
    check("solution", m_directions ? m_reduced.solve(b, x) : m_solver.solve(b, x));
    add_combination(x, m_constants, Vectors(-gram_matrix(masses, x, coefficients())));
    return x;
  }

  std::string m_function;
  const Mesh_view& m_mesh;
  Eigen::VectorXd m_areas;
  Hermitian_sparse_matrix<Quaternion<double>> m_X;
  typename SolverTraits::template Solver<Quaternion<double>> m_solver;
  std::unique_ptr<Prescribed_directions<SolverTraits>> m_directions;
  Reduced_hermitian_solver m_reduced;
  Curvature_potential m_rho = no_potential(m_mesh);
  Vectors m_constants;
  double m_regularization = 0;  // of the diagonal, in M_V
};

}  // namespace Conformal_geometry_processing

#endif
