// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRAL_PROBLEM_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRAL_PROBLEM_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/krylov_schur.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Dirac_pencil.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Conformal_geometry_processing/spin/Surface_dirac_equation.h>
#include <Conformal_geometry_processing/spin/separate_signs.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief finds eigenvalues and eigenfunctions of D - rho next to a shift s, on closed surfaces and
/// on surfaces with boundary where D is self-adjoint [CGP (5.2), 5.8.2].
///
/// With A = D - rho - s they are those of largest 1/g of A*A lambda = g B*A lambda, which the
/// Krylov-Schur method finds: A*A is positive definite and is factored, once per call of `find()`.
/// It is not where A = D: then the constants are in the kernel of both sides and lead to no value,
/// so they are taken out before and have mean zero with the others.
///
/// The eigenvalue of this pencil is s + (g_0^2 + delta^2) / g_0, where s + g_0 is the true one and
/// delta the discretisation error. So vectors that are nearer than delta to the shift are taken for
/// others farther away, and are found by the standard problem [CGP (5.3)] instead, on the same
/// factor. The eigenvalues told are quotients of the vectors, which err by O(h^2) whatever the
/// shift.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class SolverTraits = Default_solver_traits>
class Dirac_spectral_problem {
  using Vectors = Block<Quaternion<double>>;
  using Go_further = std::function<bool(const Krylov_progress&)>;

 public:
  /// \param mesh is copied
  /// \param condition with a boundary: of directions orthogonal to the tangents, such as binormals
  /// \param function named in exceptions
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with finite
  /// coordinates and positive areas, or the condition does not fit it
  /// \throw Solver_error if the analysis fails
  explicit Dirac_spectral_problem(const Mesh_view& mesh, const Boundary_condition& condition = {},
                                  const std::string& function = "Dirac_spectral_problem")
      : m_function(function),
        m_frame(checked(mesh, condition, function).positions()),
        m_mesh(m_frame.to_frame(mesh.positions()), mesh.corners()),
        m_pencil(m_mesh, condition, function)
  {}

  /// \param rho finite, in 1/length
  /// \param count how many eigenvalues
  /// \param go_further called with `Krylov_progress` now and then; false cancels
  /// \throw Precondition_error if rho does not fit the mesh, or there are not so many eigenvalues
  /// \throw Solver_error if a matrix cannot be factored. No convergence is a field of the result.
  Dirac_spectrum find(const Curvature_potential& rho, int count,
                      const Dirac_spectrum_options& options = {}, const Go_further& go_further = {})
  {
    require_input(rho, count, options.shift);
    m_pencil.set_potential(
        {rho.on, (rho.values.array() + options.shift).matrix() * m_frame.unit()});
    Dirac_spectrum s;
    s.size_of_constants =
        static_cast<int>((std::min<Eigen::Index>)(count, m_pencil.constants().cols()));
    Krylov_result r;
    r.converged = true;
    std::vector<Pair> pairs;
    if (count > s.size_of_constants) {
      const int wanted = count - s.size_of_constants;
      r = iterate(m_pencil.of_form(), wanted, options, go_further);
      pairs = with_those_at_the_shift(r, options);
      pairs.resize((std::min)(pairs.size(), static_cast<std::size_t>(wanted)));
    }
    s.restarts = r.restarts;
    s.converged = r.converged;
    s.cancelled = r.cancelled;
    fill(pairs, options.shift, s);
    return s;
  }

 private:
  /// an eigenvector, its quotient and its eigenvalue of the pencil, both minus the shift, in the
  /// frame
  struct Pair {
    double quotient, of_pencil, residual;
    Quaternion_vector<double> vector;

    friend bool operator<(const Pair& a, const Pair& b)
    {
      return std::abs(a.quotient) < std::abs(b.quotient);
    }
  };

  static const Mesh_view& checked(const Mesh_view& mesh, const Boundary_condition& condition,
                                  const std::string& function)
  {
    require_surface(mesh, function);
    require_condition(mesh, condition, function);
    if (!boundary_loops(mesh).empty() && !condition.is_self_adjoint())
      throw Precondition_error(
          function,
          "a surface with boundary has a spectrum where directions orthogonal to its tangents are "
          "prescribed, such as the binormals; nothing, tangents and positions do not do");
    return mesh;
  }

  void require_input(const Curvature_potential& rho, int count, double shift) const
  {
    const bool on_faces = rho.on == Curvature_potential::On::faces;
    const int size = on_faces ? m_mesh.size_of_faces() : m_mesh.size_of_vertices();
    if (rho.values.size() != size || !rho.values.allFinite() || !std::isfinite(shift))
      throw Precondition_error(m_function, "a finite shift and " + std::to_string(size) +
                                               " finite values of rho are needed");
    if (count < 1) throw Precondition_error(m_function, "no eigenvalue is asked for");
  }

  Krylov_result iterate(const Pencil& pencil, int wanted, const Dirac_spectrum_options& options,
                        const Go_further& go_further = {}) const
  {
    Krylov_options krylov;
    krylov.wanted = wanted;
    krylov.tolerance = options.tolerance;
    krylov.max_restarts = options.max_restarts;
    const auto noise = [this, seed = options.random_seed](Eigen::Index columns) mutable {
      return m_pencil.noise(columns, seed++);
    };
    return krylov_schur(pencil, m_mesh.size_of_vertices(), noise, krylov, go_further);
  }

  Pair pair(const Quaternion_vector<double>& v, double residual) const
  {
    const Dirac_forms forms = m_pencil.forms(v);
    const double form = forms.dirac(0, 0).w;
    return {form / forms.mass(0, 0).w, m_pencil.energy(v) / form, residual, v};
  }

  /// \brief the eigenpairs, those that the pencil gets wrong by others; nearest to the shift first.
  std::vector<Pair> with_those_at_the_shift(const Krylov_result& r,
                                            const Dirac_spectrum_options& options) const
  {
    std::vector<Pair> pairs = at_the_shift(r, options);
    const std::size_t count = pairs.size();
    for (Eigen::Index k = 0; k < r.values.size(); ++k) {
      const Quaternion_vector<double> v = r.vectors.col(k);
      double share = 0;  // of v in the span of those vectors
      for (std::size_t i = 0; i < count; ++i) share += squared_overlap(pairs[i].vector, v);
      if (share < 0.5) pairs.push_back(pair(v, r.residuals[k]));
    }
    std::stable_sort(pairs.begin(), pairs.end());
    return pairs;
  }

  /// \brief the eigenvectors that are nearer to the shift than the discretisation error: those of
  /// X lambda = mu M_V lambda [CGP (5.3)] whose root of mu is below all eigenvalues of the pencil,
  /// which for other vectors it nearly is.
  std::vector<Pair> at_the_shift(const Krylov_result& r,
                                 const Dirac_spectrum_options& options) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (double theta : r.values) nearest = (std::min)(nearest, std::abs(1 / theta));
    Dirac_spectrum_options rough = options;
    rough.tolerance = (std::max)(1e-3, options.tolerance);
    const int most = static_cast<int>(r.values.size());
    int count = 0;
    for (int wanted = (std::min)(2, most);; wanted = (std::min)(2 * wanted, most)) {
      count = count_below(0.8 * nearest, iterate(m_pencil.of_masses(), wanted, rough));
      if (count < wanted || wanted == most) break;
    }
    std::vector<Pair> pairs;
    if (count == 0) return pairs;
    const Krylov_result exact = iterate(m_pencil.of_masses(), count, options);
    const Vectors separated = separate_signs(exact.vectors, m_pencil.forms(exact.vectors));
    for (Eigen::Index k = 0; k < separated.cols(); ++k)
      pairs.push_back(pair(separated.col(k), exact.residuals.maxCoeff()));
    return pairs;
  }

  /// how many of the vectors have a root of mu below a bound
  int count_below(double bound, const Krylov_result& standard) const
  {
    int count = 0;
    for (Eigen::Index k = 0; k < standard.values.size(); ++k) {
      const Quaternion_vector<double> v = standard.vectors.col(k);
      count += m_pencil.energy(v) < bound * bound * m_pencil.squared_norm(v);
    }
    return count;
  }

  double squared_overlap(const Quaternion_vector<double>& a,
                         const Quaternion_vector<double>& b) const
  {
    return Conformal_geometry_processing::squared_norm(m_pencil.products(a, b)(0, 0)) /
           (m_pencil.squared_norm(a) * m_pencil.squared_norm(b));
  }

  void fill(const std::vector<Pair>& pairs, double shift, Dirac_spectrum& s) const
  {
    const Eigen::Index constants = s.size_of_constants,
                       size = constants + static_cast<Eigen::Index>(pairs.size());
    s.eigenvalues = s.pencil_eigenvalues = Eigen::VectorXd::Constant(size, shift);
    s.residuals = Eigen::VectorXd::Zero(size);
    s.vectors.resize(m_mesh.size_of_vertices(), size);
    for (Eigen::Index k = 0; k < constants; ++k)
      s.vectors.col(k) = m_pencil.normalized(m_pencil.constants().col(k));
    Eigen::Index k = constants;
    for (const Pair& p : pairs) {
      s.eigenvalues[k] = shift + p.quotient / m_frame.unit();
      s.pencil_eigenvalues[k] = shift + p.of_pencil / m_frame.unit();
      s.residuals[k] = p.residual;
      s.vectors.col(k++) = m_pencil.normalized(p.vector);
    }
  }

  std::string m_function;
  Normalized_frame m_frame;
  Mesh_view m_mesh;  // in the frame
  Dirac_pencil<SolverTraits> m_pencil;
};

}  // namespace Conformal_geometry_processing

#endif
