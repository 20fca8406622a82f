// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Position_derivative.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/edge_derivative.h>

#include <Eigen/Core>

#include <utility>

namespace Conformal_geometry_processing::internal {

Position_derivative::Position_derivative(const Dirac_system& system,
                                         const Poisson_reconstruction& reconstruction,
                                         const Mesh_view& measured,
                                         Quaternion_vector<double> lambda, Points f)
    : m_system(system),
      m_reconstruction(reconstruction),
      m_lambda(std::move(lambda)),
      m_placement(measured, std::move(f))
{
  if (system.is_closed())
    for (Eigen::Index i = 0; i < m_lambda.size(); ++i) m_mean += system.areas()[i] * m_lambda[i].w;
}

// The mean stays real by a right factor 1 + c with an imaginary c.
Points Position_derivative::apply(Quaternion_vector<double> dlambda) const
{
  if (m_mean != 0) {
    Quaternion<double> c;
    for (Eigen::Index i = 0; i < dlambda.size(); ++i)
      c -= m_system.areas()[i] / m_mean * dlambda[i];
    c.w = 0;
    for (Eigen::Index i = 0; i < dlambda.size(); ++i) dlambda[i] += m_lambda[i] * c;
  }
  return m_placement.apply(
      m_reconstruction.positions(edge_change(m_system.surface(), m_lambda, dlambda)));
}

Quaternion_vector<double> Position_derivative::apply_transpose(const Points& y) const
{
  Quaternion_vector<double> q =
      edge_gradient(m_system.surface(), m_lambda,
                    m_reconstruction.edge_gradient(m_placement.apply_transpose(y).transpose()));
  if (m_mean != 0) {
    Quaternion<double> turn = inner_product(m_lambda, q);
    turn.w = 0;
    for (Eigen::Index i = 0; i < q.size(); ++i) q[i] -= m_system.areas()[i] / m_mean * turn;
  }
  return q;
}

}  // namespace Conformal_geometry_processing::internal
