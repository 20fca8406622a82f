// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_ROBUST_SPIN_TRANSFORMATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_ROBUST_SPIN_TRANSFORMATION_H

#include <Conformal_geometry_processing/linear_algebra/Grounded_solver.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/delaunay_operators.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief spin transformations of closed surfaces whose triangles are as bad as they may be:
/// needles, caps, area zero.
///
/// What `Spin_transformation` does with the operators of `delaunay_operators.h`, in the same units,
/// with the same branch of eigenvalues. Where the mesh is intrinsically Delaunay it finds the same
/// surface. The vertices of a degenerate face end up where the surface of its neighbours has them.
///
/// Area, centroid and certificate are measured on the triangles of the triangulation, in the place
/// of faces; those that are folded, so that the chords of their edges enclose less than half of
/// their area, are left out.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits>
class Robust_spin_transformation {
 public:
  /// \param mesh is copied
  /// \param mollification see `mollified_lengths()`
  /// \param function named in exceptions
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold without boundary
  /// and with finite coordinates, if all of its faces have area zero, or mollification is not in
  /// (0, 1)
  /// \throw Solver_error if the analysis fails or the Laplacian cannot be factored
  explicit Robust_spin_transformation(const Mesh_view& mesh, double mollification = 1e-6,
                                      const std::string& function = "Robust_spin_transformation")
      : m_function(function),
        m_frame(checked(mesh, mollification, function).positions()),
        m_mesh(m_frame.to_frame(mesh.positions()), mesh.corners()),
        m_view(m_mesh, mollification),
        m_chords(unfolded_triangles(m_view)),
        m_dirac(m_view),
        m_L(cotan_laplacian(m_view, m_dirac.problem().matrix().shared_pattern())),
        m_poisson(m_L.shared_pattern(), m_dirac.problem().solver())
  {
    m_poisson.factorize(m_L);
  }

  Robust_spin_transformation(const Robust_spin_transformation&) = delete;
  Robust_spin_transformation& operator=(const Robust_spin_transformation&) = delete;

  /// the triangulation, in the frame of the computation
  const Delaunay_view& view() const { return m_view; }

  /// \param rho in 1/length of the mesh, one number per vertex or per face of the mesh
  /// \param options `kernel_tolerance` has no meaning here
  /// \param go_further asked between iterations with an `Eigen_progress`; false cancels
  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  /// \throw Solver_error if a factorization fails. No convergence is a field of the report.
  template <class GoFurther = Always_go_further>
  Spin_result transform(const Curvature_potential& rho, const Dirac_options& options = {},
                        GoFurther go_further = {})
  {
    require_potential(m_mesh, rho, m_frame.unit(), m_function);
    Dirac_solution s = m_dirac.solve({rho.on, rho.values * m_frame.unit()}, options, go_further);
    Spin_result result;
    result.report = report_of(s, m_frame.unit());
    result.lambda = std::move(s.lambda);
    if (!result.report.cancelled) reconstruct(result);
    return result;
  }

 private:
  static const Mesh_view& checked(const Mesh_view& mesh, double mollification,
                                  const std::string& function)
  {
    require_manifold(mesh, function);
    require_closed(mesh, function);
    require_some_area(mesh, function);
    if (!(mollification > 0 && mollification < 1))
      throw Precondition_error(function, "a mollification of " + std::to_string(mollification) +
                                             "; a number between 0 and 1 is needed");
    return mesh;
  }

  static Mesh_view unfolded_triangles(const Delaunay_view& view)
  {
    Mesh_view::Corners corners;
    for (int t = 0; t < view.size_of_triangles(); ++t) {
      const auto& v = view.corners(t);
      const Eigen::Vector3d p = view.positions().col(v[0]);
      const double twice =
          (view.positions().col(v[1]) - p).cross(view.positions().col(v[2]) - p).norm();
      if (twice > view.area(t)) corners.push_back(v);
    }
    return {view.positions(), std::move(corners)};
  }

  void reconstruct(Spin_result& result)
  {
    Spin_report& r = result.report;
    Points f = positions(result.lambda, r.closure_residual);
    restore_area(m_chords, f, result.lambda);  // faces of no area may have got wrinkles
    r.conformality = conformality(m_chords, f, rotated_normals(m_chords, result.lambda));
    const auto size = components(result.lambda).colwise().norm();
    r.min_spin_ratio = size.minCoeff() / size.maxCoeff();
    r.converged = r.converged && f.allFinite();
    result.positions = m_frame.from_frame(std::move(f));
  }

  /// As `Poisson_reconstruction`, with the chords of the edges of the triangulation.
  Points positions(const Quaternion_vector<double>& lambda, double& residual) const
  {
    Eigen::MatrixX3d divergence = Eigen::MatrixX3d::Zero(m_view.size_of_vertices(), 3);
    m_L.for_each_entry([&](int i, int j, double l) {
      if (i == j) return;
      const Eigen::RowVector3d e = -l * edge_between(lambda, j, i).transpose();
      divergence.row(i) += e;
      divergence.row(j) -= e;
    });
    const Points f = m_poisson.solve(divergence).transpose();
    double difference = 0, total = 0;
    m_L.for_each_entry([&](int i, int j, double l) {
      if (i == j) return;
      const Eigen::Vector3d e = edge_between(lambda, j, i);
      difference += std::abs(l) * (f.col(i) - f.col(j) - e).squaredNorm();
      total += std::abs(l) * e.squaredNorm();
    });
    residual = std::sqrt(difference / total);
    return f;
  }

  Eigen::Vector3d edge_between(const Quaternion_vector<double>& lambda, int i, int j) const
  {
    return transformed_edge(m_mesh.position(j) - m_mesh.position(i), lambda[i], lambda[j]);
  }

  std::string m_function;
  Normalized_frame m_frame;
  Mesh_view m_mesh;  // in the frame
  Delaunay_view m_view;
  Mesh_view m_chords;  // its triangles, straight
  Dirac_equation<SolverTraits, EigensolverTraits, Delaunay_view> m_dirac;
  Hermitian_sparse_matrix<double> m_L;
  Grounded_solver<SolverTraits> m_poisson;
};

}  // namespace Conformal_geometry_processing

#endif
