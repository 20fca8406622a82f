// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Compares the conformal Willmore flow with CGAL's `smooth_shape()`, a mean curvature flow that
/// preserves angles better than most others: measures the triangles when the surface is equally
/// round. Prints a line of JSON for each mesh, method and roundness.
///
/// Usage: benchmark_smooth_shape MESH.off...
///
/// Meshes have the area 4 pi, so that time steps are comparable. Roundness is the area-weighted
/// standard deviation of the distance from the centroid, divided by its mean.
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/smooth_shape.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <utility>
#include <vector>

#include "support/Record.h"
#include "support/clock.h"
#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

const double targets[] = {0.1, 0.03, 0.01, 0};  // 0 cannot be reached: the roundest of all
const int flow_steps = 20;
const unsigned smooth_shape_steps = 200;

/// a surface on the way, and the seconds of the processor until there
struct Moment {
  CGP::Points positions;
  double seconds;
};
using Way = std::vector<Moment>;

/// notes the surface after every step
struct Recorder : CGP::Flow_visitor {
  Way way;
  double begin = cpu_seconds();

  void on_step_end(const CGP::Flow_step_report&, const CGP::Mesh_view& mesh)
  {
    way.push_back({mesh.positions(), cpu_seconds() - begin});
  }
};

Way flow(const CGP::Mesh_view& mesh, double time_step)
{
  CGP::Flow_options options;
  options.time_step = time_step;
  options.max_steps = flow_steps;
  options.surface.exact_conformal_class = false;
  Recorder recorder;
  CGP::Conformal_willmore_flow flow(mesh, options);
  (void)flow.run(recorder);
  return std::move(recorder.way);
}

/// A sparse Cholesky factorization that exposes its solution: one coordinate of all vertices
class Watched_solver : public CGAL::Eigen_solver_traits<
                           Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>> {
 public:
  explicit Watched_solver(std::function<void(const Vector&)> on_solution)
      : m_on_solution(std::move(on_solution))
  {}

  bool linear_solver(const Vector& b, Vector& x)
  {
    if (!Eigen_solver_traits::linear_solver(b, x)) return false;
    m_on_solution(x);
    return true;
  }

 private:
  std::function<void(const Vector&)> m_on_solution;
};

Mesh surface_mesh(const CGP::Mesh_view& view)
{
  using Vertex = Mesh::Vertex_index;
  Mesh mesh;
  for (int v = 0; v < view.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = view.position(v);
    mesh.add_vertex({p.x(), p.y(), p.z()});
  }
  for (int f = 0; f < view.size_of_faces(); ++f) {
    const auto& [a, b, c] = view.corners(f);
    mesh.add_face(Vertex(static_cast<unsigned>(a)), Vertex(static_cast<unsigned>(b)),
                  Vertex(static_cast<unsigned>(c)));
  }
  return mesh;
}

// A single call, because the next one would start from its own Laplacian. Surfaces are observed as
// solutions of the linear system, before scaling, which does not affect our measures.
Way smooth_shape(const CGP::Mesh_view& view, double time_step)
{
  Mesh mesh = surface_mesh(view);
  Way way;
  const double begin = cpu_seconds();
  CGP::Points positions(3, view.size_of_vertices());
  Eigen::Index coordinate = 0;
  const Watched_solver solver([&](const Eigen::VectorXd& x) {
    positions.row(coordinate) = x.transpose();
    coordinate = (coordinate + 1) % 3;
    if (coordinate == 0) way.push_back({positions, cpu_seconds() - begin});
  });
  CGAL::Polygon_mesh_processing::smooth_shape(
      mesh, time_step,
      CGAL::parameters::number_of_iterations(smooth_shape_steps).sparse_linear_solver(solver));
  return way;
}

double roundness(const CGP::Mesh_view& mesh)
{
  const Eigen::VectorXd weights = CGP::vertex_areas(mesh) / CGP::vertex_areas(mesh).sum();
  const Eigen::Vector3d centre = mesh.positions() * weights;
  const Eigen::VectorXd r = (mesh.positions().colwise() - centre).colwise().norm();
  const double mean = r.dot(weights);
  return std::sqrt((r.array() - mean).square().matrix().dot(weights)) / mean;
}

/// the first moment at which the surface is as round as that, or else the roundest
std::size_t place_of(double target, const std::vector<double>& roundness)
{
  for (std::size_t i = 0; i < roundness.size(); ++i)
    if (roundness[i] <= target) return i;
  return static_cast<std::size_t>(std::min_element(roundness.begin(), roundness.end()) -
                                  roundness.begin());
}

void describe(const CGP::Mesh_view& initial, const Moment& moment, Record& record)
{
  const CGP::Mesh_view mesh(moment.positions, initial.corners());
  const CGP::Conformality map =
      CGP::conformality(initial, moment.positions, CGP::neighbourhood_normals(mesh));
  record.add("q_mean", map.quasi_conformal.mean).add("q_max", map.quasi_conformal.max);
  record.add("flips", map.flipped_faces);
  record.add("energy", CGP::willmore_energy(mesh)).add("seconds", moment.seconds);
}

void print(const std::string& name, const std::string& method, double time_step,
           const CGP::Mesh_view& initial, const Way& way)
{
  std::vector<double> all;
  for (const Moment& moment : way) all.push_back(roundness({moment.positions, initial.corners()}));
  for (const double target : targets) {
    Record record;
    record.add("mesh", name).add("faces", initial.size_of_faces()).add("method", method);
    record.add("time_step", time_step).add("target", target);
    if (!way.empty()) {
      const std::size_t i = place_of(target, all);
      record.add("steps", static_cast<int>(i) + 1).add("roundness", all[i]);
      describe(initial, way[i], record);
    }
    record.print();
  }
}

void compare(const std::string& path)
{
  const CGP::Mesh_view mesh = make_mesh(path);
  const std::string name = path.substr(path.rfind('/') + 1);
  for (const double time_step : {1., 0.5, 0.25})
    print(name, "conformal Willmore flow", time_step, mesh, flow(mesh, time_step));
  for (const double time_step : {1e-3, 1e-2, 1e-1, 1.})
    print(name, "smooth_shape", time_step, mesh, smooth_shape(mesh, time_step));
}

}  // namespace

int main(int argc, char* argv[])
{
  try {
    for (int i = 1; i < argc; ++i) compare(argv[i]);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_smooth_shape: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
