// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_SOLVER_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/forms/Dirac_energy_inverse.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

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
  explicit Dirac_energy_solver(const Mesh_view& mesh) : m_mesh(mesh), m_X(vertex_graph(mesh))
  {
    check("analysis", m_solver.analyze_with_positions(m_X.pattern(), mesh.positions()));
    update_geometry();
  }

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
  void update_geometry()
  {
    const double pi = std::acos(-1.);
    m_areas = vertex_areas(m_mesh);
    assemble_dirac_energy(m_mesh, no_potential(m_mesh), m_X);
    const double unit = 4 * pi / m_areas.sum();  // the size of the low eigenvalues
    Solver_status status = m_solver.factorize(m_X, 1e-5 * unit * m_areas);
    if (status == Solver_status::not_positive_definite)  // to rounding, where there are slivers
      status = m_solver.factorize(m_X, 1e-2 * unit * m_areas);
    check("factorization", status);
  }

  /// \brief the solutions Y with sum_i M_V,i Y_i = 0, see `Dirac_energy_inverse`.
  Block<Quaternion<double>> operator()(const Block<Quaternion<double>>& c) const
  {
    return Dirac_energy_inverse<Solver>(m_X, m_areas, m_solver)(c);
  }

  const Solver& solver() const { return m_solver; }

 private:
  static void check(const char* step, Solver_status status)
  {
    if (status != Solver_status::success)
      throw Solver_error("Dirac_energy_solver",
                         std::string(step) + " of X failed: " + to_string(status));
  }

  const Mesh_view& m_mesh;
  Eigen::VectorXd m_areas;  // |V|
  Hermitian_sparse_matrix<Quaternion<double>> m_X;
  Solver m_solver;
};

}  // namespace Conformal_geometry_processing

#endif
