// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_SOLVER_H

#include <Conformal_geometry_processing/forms/Dirac_energy_inverse.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// \brief solves D^H M_F D Y = c, with a factor of its own: `Dirac_energy_inverse` for those who
/// have none.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class SolverTraits = Default_solver_traits>
class Dirac_energy_solver {
 public:
  using Solver = typename SolverTraits::template Solver<Quaternion<double>>;

  /// \param mesh must outlive the object
  /// \pre `require_surface(mesh)` and `require_closed(mesh)` hold
  /// \throw Solver_error if the matrix cannot be factored
  explicit Dirac_energy_solver(const Mesh_view& mesh);

  /// \brief shares the analysis of another solver, on the pattern `vertex_graph(mesh)`.
  /// \param other a `Solver` of the same traits, for any scalar
  template <class OtherSolver>
  Dirac_energy_solver(const Mesh_view& mesh, const OtherSolver& other)
      : m_mesh(mesh), m_X(vertex_graph(mesh))
  {
    check("analysis", m_solver.analyze_like(m_X.pattern(), other));
    update_geometry();
  }

  Dirac_energy_solver(const Dirac_energy_solver&) = delete;
  Dirac_energy_solver& operator=(const Dirac_energy_solver&) = delete;

  /// \brief the mesh has new positions: assembles and factors on the same analysis.
  /// \throw Solver_error if the matrix cannot be factored
  void update_geometry();

  /// \brief the solutions Y with sum_i M_V,i Y_i = 0, see `Dirac_energy_inverse`.
  Block<Quaternion<double>> operator()(const Block<Quaternion<double>>& c) const;

  const Solver& solver() const { return m_solver; }

 private:
  static void check(const char* step, Solver_status status);

  const Mesh_view& m_mesh;
  Eigen::VectorXd m_areas;  // |V|
  Hermitian_sparse_matrix<Quaternion<double>> m_X;
  Solver m_solver;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/forms/Dirac_energy_solver_templates.h>
#endif

#endif
