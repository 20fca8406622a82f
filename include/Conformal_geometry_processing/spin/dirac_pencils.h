// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_PENCILS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_PENCILS_H

#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Krylov_space.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/constant_spins.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

/// \file dirac_pencils.h
/// \brief the Hermitian pencils of D - rho on the space of spins of a `Dirac_system` with potential
/// rho. They refer to the system and to the excluded constants.

namespace Conformal_geometry_processing {
namespace internal {

/// the constants in the space of spins, M_V-orthonormal: the kernel of X for rho = 0
template <class SolverTraits>
Block<Quaternion<double>> constants_in_space(const Dirac_system<SolverTraits>& system)
{
  Vector<Quaternion<double>> spins =
      Vector<Quaternion<double>>::Constant(1, Quaternion<double>{1, 0, 0, 0});
  if (system.directions()) spins = constant_spins(system.directions()->basis());
  Block<Quaternion<double>> v(system.areas().size(), spins.size());
  for (Eigen::Index c = 0; c < v.cols(); ++c)
    v.col(c).setConstant(spins[c] / std::sqrt(system.areas().sum()));
  return v;
}

/// the part of a right-hand side b that vanishes on the constants
template <class SolverTraits>
Block<Quaternion<double>> beside_constants(const Dirac_system<SolverTraits>& system,
                                           const Block<Quaternion<double>>& constants,
                                           Block<Quaternion<double>> b)
{
  using Vectors = Block<Quaternion<double>>;
  add_combination(b, Vectors(block_operator(system.areas())(constants)),
                  Vectors(-gram_matrix(constants, b, system.coefficients())));
  return b;
}

/// \brief X^-1 b without its constant component: that of b is rounding error, which the factor
/// would amplify.
template <class SolverTraits>
Block<Quaternion<double>> solve_beside(const Dirac_system<SolverTraits>& system,
                                       const Block<Quaternion<double>>& constants,
                                       Block<Quaternion<double>> b)
{
  using Vectors = Block<Quaternion<double>>;
  Vectors x = system.solve(beside_constants(system, constants, std::move(b)));
  const Vectors masses = block_operator(system.areas())(constants);
  add_combination(x, constants, Vectors(-gram_matrix(masses, x, system.coefficients())));
  return x;
}

/// K = M_V, N = X with the shift of its factor. K vanishes on the constants too: what rounding
/// brings in of them, which have the smallest N, would otherwise appear as the largest eigenvalue.
template <class SolverTraits>
Pencil pencil_of_masses(const Dirac_system<SolverTraits>& system,
                        const Block<Quaternion<double>>& constants)
{
  using Vectors = Block<Quaternion<double>>;
  Pencil pencil;
  pencil.coefficients = system.coefficients();
  pencil.K = [&system, &constants](const Vectors& v) {
    return system.projected(beside_constants(system, constants, block_operator(system.areas())(v)));
  };
  pencil.N = [&system](const Vectors& v) {
    Vectors w = block_operator(system.matrix())(v);
    for (Eigen::Index c = 0; c < v.cols(); ++c)
      for (Eigen::Index i = 0; i < v.rows(); ++i)
        w(i, c) += (system.shift() * system.areas()[i]) * v(i, c);
    return system.projected(std::move(w));
  };
  pencil.solve = [&system, &constants](const Vectors& b) {
    return solve_beside(system, constants, b);
  };
  return pencil;
}

/// K = the Hermitian part of B^H M (D - R), N as before
template <class SolverTraits>
Pencil pencil_of_form(const Dirac_system<SolverTraits>& system, const Curvature_potential& rho,
                      const Block<Quaternion<double>>& constants)
{
  using Vectors = Block<Quaternion<double>>;
  Pencil pencil = pencil_of_masses(system, constants);
  pencil.K = [&system, &rho](const Vectors& v) {
    Vectors w(v.rows(), v.cols());
    for (Eigen::Index c = 0; c < v.cols(); ++c)
      w.col(c) = apply_dirac_form(system.surface(), rho, v.col(c));
    return system.projected(std::move(w));
  };
  return pencil;
}

/// `dirac_forms()` over the scalars of the space
template <class SolverTraits>
Dirac_forms forms_in_space(const Dirac_system<SolverTraits>& system, const Curvature_potential& rho,
                           const Block<Quaternion<double>>& v)
{
  Dirac_forms forms = dirac_forms(system.surface(), rho, v);
  for (Block<Quaternion<double>>* form : {&forms.dirac, &forms.mass})
    for (Eigen::Index k = 0; k < form->size(); ++k)
      form->data()[k] = reduced_to(system.coefficients(), form->data()[k]);
  return forms;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
