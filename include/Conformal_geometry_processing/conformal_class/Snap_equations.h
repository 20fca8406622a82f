// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_class/Class_equations.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <Eigen/Core>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief Directions of a surface along its boundary, from which those of other surfaces of the
/// same connectivity must not differ: for each edge of the boundary, the direction U = t T + n N +
/// b B in the frame of its face, with the edge T, the normal N, and B = T x N out of the surface.
///
/// Tangents concern the ends of the edge, normals and binormals also the third vertex of its face.
class Rim_directions {
 public:
  /// The derivative of a residual by the positions of the vertices of a face
  struct Row {
    std::array<int, 3> vertices;
    Eigen::Matrix3d gradients;  ///< in columns, in the order of the vertices
  };

  /// keeps nothing
  Rim_directions() = default;

  /// \param mesh whose directions are kept
  /// \param direction (t, n, b), of any nonzero length
  Rim_directions(const Mesh_view& mesh, const Eigen::Vector3d& direction);

  /// the number of residuals: two for each edge of the boundary
  Eigen::Index size_of_rows() const { return 2 * m_normals.cols(); }

  /// \brief The components of U(f) orthogonal to the kept directions: angles in radians, to first
  /// order.
  Eigen::VectorXd residuals(const Points& f) const;

  /// the derivatives of the residuals
  std::vector<Row> derivative(const Points& f) const;

 private:
  Eigen::Vector3d m_direction;
  std::vector<std::array<int, 3>> m_faces;  // of each edge: its ends, and the third vertex
  Points m_normals, m_others;               // two unit vectors orthogonal to each kept direction
};

/// \brief One equation for all positions, such as that of an enclosed volume. Motions of the
/// surface must have no effect.
struct Global_equation {
  std::function<double(const Points&)> residual;
  std::function<Points(const Points&)> gradient;  ///< 3 x |V|
};

/// \brief The smallest change (df, du) of a surface and its log scales that removes given residuals
/// of `Edge_scales` and `Rim_directions`, to first order.
///
/// Minimizes eps G(d) + |c + J d|^2, with G(d) = sum |df_j - df_i|^2 / |f_j - f_i|^2 + .01 |du|^2,
/// a `Class_form` on the vertex graph. G does not see translations: the first vertex of each
/// component is held, which changes the solution by a translation only. A `Global_equation`, whose
/// derivative is dense, is met exactly.
///
/// On isothermic surfaces, such as spheres, J loses rank, and a large eps converges slowly. Where
/// edges differ in length by many orders of magnitude, a small one drowns in rounding.
class Snap_equations {
 public:
  /// where a factorization has linearized
  struct Linearization {
    Points f;
    Rim_directions rim;
    double eps;
  };

  /// \brief What solutions depend on beside residuals and surface: the last factor, and the damping
  /// of the next one. A copy costs nothing, for a factor is computed again where it is needed.
  struct State {
    std::shared_ptr<const Linearization> last;
    double eps = 1e-6;
  };

  /// \param graph the `vertex_graph()` of the mesh
  Snap_equations(const Mesh_view& mesh, const Sparse_pattern& graph);

  const Edge_scales& scales() const { return m_form.scales(); }

  /// adds the residuals of a rim, from the next factorization
  void keep(Rim_directions rim);

  /// adds an equation, from the next factorization
  void keep(Global_equation equation);

  /// \brief Linearizes at f and factors the matrix, damped until it is positive definite.
  /// \throw Solver_error if that fails, or an edge has no length
  void factorize(const Points& f);

  /// \brief Takes up the last factor if it serves at f: edges have changed since by less than a
  /// fifth of their lengths, in the mean. Computes it again if a state with another one was set.
  /// \returns whether there is one that serves
  /// \throw Solver_error if that fails
  bool resume(const Points& f);

  const State& state() const { return m_state; }
  void set_state(State state) { m_state = std::move(state); }

  /// \brief Multiplies eps by ten for later factorizations.
  /// \returns false if it is as large as makes sense
  bool damp();

  /// \brief Divides eps by ten for later factorizations: where J is nearly singular, the last
  /// digits converge slowly otherwise.
  void undamp();

  double damping() const { return m_state.eps; }
  void set_damping(double eps) { m_state.eps = eps; }

  /// \brief Solves with the last factor and the J of that surface.
  /// \param c the residuals: |E|, those of the rim, and that of the global equation
  /// \param df 3 x |V|, mean zero on each component; du |V|
  /// \throw Solver_error if the solution is not finite
  void solve(const Eigen::VectorXd& c, Points& df, Eigen::VectorXd& du) const;

 private:
  bool serves(const Linearization& at, const Points& f) const;
  Solver_status factorize(const Linearization& at);
  void assemble(const Linearization& at);
  void add_rim_row(const Rim_directions::Row& row);
  void solve_global(const Points& gradient);
  void center(Points& df) const;

  std::vector<int> m_components;  // of the vertices
  Class_form m_form;
  Supernodal_cholesky<double> m_solver;
  Rim_directions m_rim;
  std::vector<Rim_directions::Row> m_rim_rows;
  std::optional<Global_equation> m_global;
  Block<double> m_global_gradient, m_global_response;  // what the factor makes of the gradient
  State m_state;
  std::shared_ptr<const Linearization> m_factorized;  // that of the factor
};

}  // namespace Conformal_geometry_processing::internal
