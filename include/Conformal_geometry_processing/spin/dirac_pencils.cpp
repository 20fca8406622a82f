// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/dirac_pencils.h>

namespace Conformal_geometry_processing::internal {

Block<Quaternion<double>> constants_in_space(const Dirac_system& system)
{
  Vector<Quaternion<double>> spins =
      Vector<Quaternion<double>>::Constant(1, Quaternion<double>{1, 0, 0, 0});
  if (system.directions()) spins = constant_spins(system.directions()->basis());
  Block<Quaternion<double>> v(system.areas().size(), spins.size());
  for (Eigen::Index c = 0; c < v.cols(); ++c)
    v.col(c).setConstant(spins[c] / std::sqrt(system.areas().sum()));
  return v;
}

Block<Quaternion<double>> beside_constants(const Dirac_system& system,
                                           const Block<Quaternion<double>>& constants,
                                           Block<Quaternion<double>> b)
{
  using Vectors = Block<Quaternion<double>>;
  add_combination(b, Vectors(block_operator(system.areas())(constants)),
                  Vectors(-gram_matrix(constants, b, system.coefficients())));
  return b;
}

Block<Quaternion<double>> solve_beside(const Dirac_system& system,
                                       const Block<Quaternion<double>>& constants,
                                       Block<Quaternion<double>> b)
{
  using Vectors = Block<Quaternion<double>>;
  Vectors x = system.solve(beside_constants(system, constants, std::move(b)));
  const Vectors masses = block_operator(system.areas())(constants);
  add_combination(x, constants, Vectors(-gram_matrix(masses, x, system.coefficients())));
  return x;
}

Pencil pencil_of_masses(const Dirac_system& system, const Block<Quaternion<double>>& constants)
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

Pencil pencil_of_form(const Dirac_system& system, const Curvature_potential& rho,
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

Dirac_forms forms_in_space(const Dirac_system& system, const Curvature_potential& rho,
                           const Block<Quaternion<double>>& v)
{
  Dirac_forms forms = dirac_forms(system.surface(), rho, v);
  for (Block<Quaternion<double>>* form : {&forms.dirac, &forms.mass})
    for (Eigen::Index k = 0; k < form->size(); ++k)
      form->data()[k] = reduced_to(system.coefficients(), form->data()[k]);
  return forms;
}

}  // namespace Conformal_geometry_processing::internal
