// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_FLOW_BALANCE_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_FLOW_BALANCE_H

#include <Conformal_geometry_processing/algebra/Moebius_map.h>
#include <Conformal_geometry_processing/flow/Flow_options.h>
#include <Conformal_geometry_processing/flow/Moebius_balancing.h>
#include <Conformal_geometry_processing/flow/canonical_area_density.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief keeps the balance of a flow in the way its options ask for, if they do.
class Flow_balance {
 public:
  /// \param mesh the surface the flow starts from
  /// \param laplacian a function of no argument that returns a `Grounded_solver` with the factor
  /// of its Laplacian; called for the canonical metric only
  /// \param function named in exceptions
  /// \throw Precondition_error if a prescribed area is not positive, their number is not that of
  /// the vertices, or the canonical metric of a sphere is asked for
  template <class Laplacian>
  Flow_balance(const Mesh_view& mesh, const Flow_options& options, Laplacian laplacian,
               const std::string& function)
      : m_way(options.balancing)
  {
    if (options.balance == Balance::none) return;
    require_closed(mesh, function);
    m_balancing.emplace(target_areas(mesh, options, laplacian, function), function);
    (void)m_balancing->imbalance(mesh);  // finds out about a wrong number of areas
  }

  /// \brief what to add to the curvature potential of a step, |V| numbers in 1/length; zero if
  /// balance is not kept in this way.
  ///
  /// Not to be multiplied by the time step: the surface can go all the way back at once.
  Eigen::VectorXd potential(const Mesh_view& mesh) const;

  /// whether `inverted()` is to be applied after a step
  bool is_by_inversion() const { return m_balancing && m_way == Balancing::inversion; }

  /// \brief the balanced image of the surface under sphere inversions, with its area and centroid.
  /// \pre `is_by_inversion()`
  Points inverted(Mesh_view mesh) const;

 private:
  template <class Laplacian>
  static Eigen::VectorXd target_areas(const Mesh_view& mesh, const Flow_options& options,
                                      Laplacian laplacian, const std::string& function)
  {
    if (options.balance == Balance::prescribed) return options.target_areas;
    if (options.balance == Balance::initial) return vertex_areas(mesh);
    const Hodge_decomposition forms(mesh, closed_generators(mesh), laplacian());
    return canonical_vertex_areas(mesh, canonical_area_density(forms.harmonic_basis(), function));
  }

  Balancing m_way;
  std::optional<Moebius_balancing> m_balancing;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/flow/Flow_balance_impl.h>
#endif

#endif
