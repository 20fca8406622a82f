// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// CGAL's modified mean curvature flow with the solver that all methods have.
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <limits>
#include <memory>
#include <utility>

#include "Method.h"
#include "Real_cholesky.h"

namespace cgp_benchmark {
namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// thrown through `smooth_shape()`, which has no other way to be stopped
struct Is_over {};

/// \brief A model of CGAL's `SparseLinearAlgebraWithFactorTraits_d` that passes the surface of the
/// previous step to an observer before each factorization except the first.
///
/// Copies share their state.
class Watched_cholesky {
 public:
  using NT = double;
  using Vector = CGAL::Eigen_vector<double>;
  using Matrix = CGAL::Eigen_sparse_matrix<double>;

  Watched_cholesky(const CGP::Mesh_view& mesh, std::function<bool()> on_step)
      : m_on_step(std::move(on_step)),
        m_matrix(std::make_shared<CGP::Hermitian_sparse_matrix<double>>(CGP::vertex_graph(mesh))),
        m_solver(std::make_shared<Real_cholesky>(m_matrix->pattern(), mesh.positions()))
  {}

  bool factor(const Matrix& A, NT& denominator)
  {
    if (!m_is_first && !m_on_step()) throw Is_over();
    m_is_first = false;
    denominator = 1;
    // The lower triangles of its columns have our pattern, in the same order.
    int k = 0;
    for (int j = 0; j < A.eigen_object().outerSize(); ++j)
      for (Matrix::EigenType::InnerIterator a(A.eigen_object(), j); a; ++a)
        if (a.row() >= j) m_matrix->value(k++) = a.value();
    m_solver->factorize(*m_matrix);
    return true;
  }

  bool linear_solver(const Vector& b, Vector& x)
  {
    CGP::Points rows = CGP::Points::Zero(3, b.size());
    rows.row(0) = b.transpose();
    static_cast<Eigen::VectorXd&>(x) = m_solver->solve(rows).row(0).transpose();
    return true;
  }

 private:
  std::function<bool()> m_on_step;
  std::shared_ptr<CGP::Hermitian_sparse_matrix<double>> m_matrix;
  std::shared_ptr<Real_cholesky> m_solver;
  bool m_is_first = true;
};

Mesh surface_mesh(const CGP::Mesh_view& view)
{
  const auto vertex = [](int v) { return Mesh::Vertex_index(static_cast<unsigned>(v)); };
  Mesh mesh;
  for (int v = 0; v < view.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = view.position(v);
    mesh.add_vertex({p.x(), p.y(), p.z()});
  }
  for (const auto& [a, b, c] : view.corners()) mesh.add_face(vertex(a), vertex(b), vertex(c));
  return mesh;
}

CGP::Points positions(const Mesh& mesh)
{
  CGP::Points p(3, static_cast<Eigen::Index>(mesh.number_of_vertices()));
  for (const auto v : vertices(mesh))
    p.col(static_cast<Eigen::Index>(v.idx())) << mesh.point(v).x(), mesh.point(v).y(),
        mesh.point(v).z();
  return p;
}

}  // namespace

// Its matrix is M / 2 + 2 t L, so its t is tau / 8. After each step it scales to the volume before.
void run_smooth_shape(const CGP::Mesh_view& view, double time_step, Surface_observer& observer)
{
  Mesh mesh = surface_mesh(view);
  const Watched_cholesky solver(view, [&] { return observer(positions(mesh)); });
  try {
    CGAL::Polygon_mesh_processing::smooth_shape(
        mesh, time_step / 8,
        CGAL::parameters::number_of_iterations(std::numeric_limits<unsigned>::max())
            .sparse_linear_solver(solver));
  } catch (const Is_over&) {
  }
}

}  // namespace cgp_benchmark
