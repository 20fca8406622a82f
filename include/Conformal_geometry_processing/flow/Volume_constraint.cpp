// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Volume_constraint.h>

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Spin_derivative.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing::internal {

Volume_constraint::Volume_constraint(const Mesh_view& faces, double reduced_volume,
                                     const std::string& function)
    : m_faces(faces), m_log_volume(std::log(reduced_volume))
{
  require_closed(faces, function);
  if (!(enclosure(faces).volume > 0))
    throw Precondition_error(function,
                             "the enclosed volume is not positive; a surface whose normals point "
                             "outward is needed");
}

double Volume_constraint::log_volume(const Points& f) const
{
  const Points in_frame = Normalized_frame(f).to_frame(f);
  return std::log(Enclosure_gradient(m_faces, in_frame).reduced_volume());
}

double Volume_constraint::distance(const Points& f) const
{
  return m_log_volume - log_volume(f);
}

double Volume_constraint::change(const Points& f, double time) const
{
  const double most = .05 * time;
  return std::clamp(distance(f), -most, most);
}

// Steps meet logarithms of lengths to 1e-3 only; what a volume misses changes the energy by as
// much.
Global_equation Volume_constraint::equation(const Points& f, double change) const
{
  const double weight = 100, wanted = log_volume(f) + change;
  return {[=](const Points& g) { return weight * (log_volume(g) - wanted); },
          [=](const Points& g) -> Points {
            return weight * Enclosure_gradient(m_faces, g).of_log_reduced_volume();
          }};
}

inline Quaternion_vector<double> spins_of_rest(const Dirac_system& system)
{
  return Quaternion_vector<double>::Constant(system.areas().size(), {1, 0, 0, 0});
}

/// z with Re <y, D^H M rho> = sum_i A_i rho_i z_i
inline Eigen::VectorXd rho_of(const Dirac_system& system, const Block<Quaternion<double>>& y)
{
  const Eigen::VectorXd of_rho =
      energy_gradient(system.surface(), no_potential(system.surface()), spins_of_rest(system), y);
  return of_rho.cwiseQuotient(system.areas());
}

/// the rho of the spins 1 + Y with the least |D Y - rho|^2 + w |Y|^2
inline Eigen::VectorXd damped(const Dirac_system& system, const Eigen::VectorXd& rho)
{
  const Block<Quaternion<double>> b =
      energy_change(system.surface(), no_potential(system.surface()), spins_of_rest(system), rho);
  return rho_of(system, system.solve(b));
}

Eigen::VectorXd Volume_constraint::gradient(Spin_transformation& transformation, int& solves) const
{
  const Dirac_system& system = transformation.system();
  const Points& f = transformation.domain().mesh().positions();
  const Position_derivative derivative(system, transformation.reconstruction(), m_faces,
                                       spins_of_rest(system), f);
  const Block<Quaternion<double>> of_spins =
      derivative.apply_transpose(Enclosure_gradient(m_faces, f).of_log_reduced_volume());
  const double tolerance = 1e-8;
  return rho_of(system, system.response(of_spins, tolerance, solves));
}

auto Volume_constraint::directions(Spin_transformation& transformation,
                                   const Constraint_basis& others,
                                   const Eigen::VectorXd& descent) const -> Directions
{
  const double w = 10;  // in 4 pi / area: the volume of lobes curves by about as much
  Dirac_system& system = transformation.system();
  Dirac_evidence::Seconds seconds;
  system.set_potential(no_potential(system.surface()), seconds, Dirac_system::Use::solution, w);
  Directions d;
  d.factorizations = 1;
  const Eigen::VectorXd z = others.project_out(gradient(transformation, d.solves));
  const Eigen::VectorXd steepest = others.project_out(damped(system, z));
  d.kept = others.project_out(damped(system, others.project_out(descent)));
  d.solves += 2;
  const Eigen::VectorXd weighted = system.areas().cwiseProduct(z);
  d.filling = steepest / weighted.dot(steepest);
  d.kept -= weighted.dot(d.kept) * d.filling;
  return d;
}

}  // namespace Conformal_geometry_processing::internal
