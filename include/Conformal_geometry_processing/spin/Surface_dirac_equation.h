// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SURFACE_DIRAC_EQUATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SURFACE_DIRAC_EQUATION_H

#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Dirac_equation.h>
#include <Conformal_geometry_processing/spin/Prescribed_directions.h>
#include <Conformal_geometry_processing/spin/Prescribed_positions.h>
#include <Conformal_geometry_processing/spin/Reduced_dirac_equation.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief refuses conditions that do not fit the surface.
///
/// \throw Precondition_error if a condition other than `free` is set and there is no boundary; if
/// the number of targets or normals is not that of the boundary vertices; if one is zero or not
/// finite; if the direction is the normal (not elliptic), zero or not finite; if the boundary of
/// the surface folds back at a vertex, which then has no frame
template <class Surface>
void require_condition(const Surface& mesh, const Boundary_condition& condition,
                       const std::string& function)
{
  using Kind = Boundary_condition::Kind;
  if (condition.kind == Kind::free) return;
  const Boundary_frames boundary = boundary_frames(mesh);
  const std::vector<int>& vertices = boundary.vertices;
  const auto count = static_cast<Eigen::Index>(vertices.size());
  if (count == 0)
    throw Precondition_error(function, "the surface is closed; no boundary can be prescribed");
  internal::refuse_if_any(
      static_cast<int>(count),
      [&](int k) { return !(boundary.frames[static_cast<std::size_t>(k)].determinant() > 0.5); },
      [&](int k) { return internal::name_of_vertex(vertices[static_cast<std::size_t>(k)]); },
      function, "boundary #vertex without tangent or normal", "the boundary must not fold back");
  const bool is_directions = condition.kind == Kind::directions;
  const auto require_size = [&](const Points& p, const std::string& what, bool is_optional) {
    if (p.cols() != count && !(is_optional && p.cols() == 0))
      throw Precondition_error(function,
                               std::to_string(p.cols()) + " " + what +
                                   ", one per boundary vertex is needed: " + std::to_string(count));
  };
  const auto require_good = [&](const Points& p, const std::string& what, bool is_direction) {
    internal::refuse_if_any(
        static_cast<int>(p.cols()),
        [&](int k) {
          return !p.col(k).allFinite() || (is_direction && !(stable_norm(p.col(k)) > 0));
        },
        [&](int k) { return internal::name_of_vertex(vertices[static_cast<std::size_t>(k)]); },
        function, what,
        is_direction ? "finite vectors that are not zero are needed"
                     : "finite coordinates are needed");
  };
  require_size(condition.targets, is_directions ? "directions" : "positions", is_directions);
  require_good(condition.targets,
               is_directions ? "#direction zero or not finite" : "#position not finite",
               is_directions);
  if (!is_directions) {
    require_size(condition.normals, "normals", false);
    require_good(condition.normals, "#normal zero or not finite", true);
    return;
  }
  const Eigen::Vector3d d = condition.direction;
  if (!d.allFinite() || !(std::hypot(d.x(), d.z()) > 1e-3 * std::abs(d.y())))
    throw Precondition_error(function,
                             "only tangents, binormals and directions between them and the normal "
                             "can be prescribed; that of the normal is not elliptic");
}

/// \ingroup PkgSpin
/// \brief solves (D - rho) lambda = gamma lambda on a surface with boundary or without: one
/// interface to `Dirac_equation`, `solve_with_free_boundary()`, `Reduced_dirac_equation` and
/// `Prescribed_positions`.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`, for closed surfaces
/// \tparam Surface `Mesh_view`, or `Delaunay_view` for the robust operators
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits, class Surface = Mesh_view>
class Surface_dirac_equation {
 public:
  using Closed = Dirac_equation<SolverTraits, EigensolverTraits, Surface>;
  using Problem = std::decay_t<decltype(std::declval<Closed>().problem())>;
  using Directions = Prescribed_directions<SolverTraits, Surface>;
  using Reduced = Reduced_dirac_equation<Problem, Directions>;

  /// \param mesh must outlive the object
  /// \pre `require_surface(mesh)` and `require_condition(mesh, condition)` hold
  /// \throw Precondition_error if positions need another spin structure
  /// \throw Solver_error if the analysis fails
  Surface_dirac_equation(const Surface& mesh, const Boundary_condition& condition,
                         const std::string& function);

  Surface_dirac_equation(const Surface_dirac_equation&) = delete;
  Surface_dirac_equation& operator=(const Surface_dirac_equation&) = delete;

  const Problem& problem() const { return m_closed.problem(); }
  Problem& problem() { return m_closed.problem(); }
  bool is_closed() const { return m_is_closed; }

  /// of the condition, or null
  const Directions* directions() const { return m_directions.get(); }
  /// of the condition, or null
  Reduced* reduced() { return m_reduced.get(); }
  /// of the condition, or null
  Prescribed_positions<SolverTraits, Problem>* positions() { return m_positions.get(); }

  /// whether gamma is a true eigenvalue, which rho is realised up to; not only a misfit
  bool is_self_adjoint() const { return m_is_closed || m_is_self_adjoint; }

  /// the mesh has new positions
  /// \pre the condition is not one of positions
  void update_geometry();

  /// \brief the change of lambda = 1 that answers to sources c for rho = 0, in the space that the
  /// condition at the boundary allows; the last factorization is lost.
  /// \pre the surface has a boundary, and no positions are prescribed
  /// \throw Solver_error if a matrix cannot be factored
  Block<Quaternion<double>> response(const Block<Quaternion<double>>& c);

  /// gives back the memory of factors, until the next `solve()`
  void release();

  /// \brief see `Dirac_equation::solve()`.
  /// \throw Precondition_error if the generalized problem is asked for on a surface with boundary
  Dirac_solution solve(const Curvature_potential& rho, const Dirac_options& options = {},
                       const Go_further& go_further = Always_go_further());

 private:
  bool m_is_closed, m_is_self_adjoint = false;
  Boundary_condition::Kind m_kind;
  Closed m_closed;
  std::unique_ptr<Directions> m_directions;
  std::unique_ptr<Reduced> m_reduced;
  std::unique_ptr<Prescribed_positions<SolverTraits, Problem>> m_positions;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Surface_dirac_equation_templates.h>
#endif

#endif
