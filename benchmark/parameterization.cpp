// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Compares parameterizations: CGAL's, CGAL's with the solver of this library, and those of this
/// library, all judged by the same measures. Prints a line of JSON for each mesh and method.
///
/// Usage: benchmark_parameterization [--method NAME]... [--cones N] MESH.off...
///
/// With cones, three or four, the meshes are spheres: they are cut open along a path through the
/// cones, and CGAL's orbifold Tutte embeddings are among the methods. Zero disables cones.
///
/// Every method runs in a separate process, for at most ten minutes, because some do not terminate
/// on some meshes. Seconds are processor time on one thread, the minimum of up to five runs; memory
/// is the peak above the mesh. *spread* is the standard deviation of the log of the scale, over the
/// area. A face is flipped if it is oriented against the area of the whole image.
#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/distortion.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "parameterization/Cut_surface.h"
#include "parameterization/Method.h"
#include "support/Record.h"
#include "support/clock.h"
#include "support/memory.h"

namespace {

using namespace cgp_benchmark;
namespace CGP = Conformal_geometry_processing;

const unsigned time_limit = 600;  // seconds
const int most_runs = 5;
const double enough_seconds = 2;  // of all runs of a method

std::vector<Method> all_methods()
{
  std::vector<Method> all = methods_of_cgal();
  for (const auto& more : {methods_of_cgal_with_our_solver(), our_methods()})
    all.insert(all.end(), more.begin(), more.end());
  all.push_back(reference_method());
  return all;
}

std::string name_of(const std::string& path)
{
  const std::string file = path.substr(path.rfind('/') + 1);
  return file.substr(0, file.rfind('.'));
}

Record begin_record(const std::string& name, const Surface& mesh, const Method& method)
{
  Record record;
  record.add("mesh", name).add("faces", static_cast<int>(mesh.number_of_faces()));
  return record.add("method", method.name);
}

void judge(const Surface& mesh, const UV_map& uv, Record& record)
{
  const CGP::Graph_view<Surface> graph(mesh, CGP::parameters::default_values(), "benchmark");
  const CGP::Mesh_view& view = graph.view();
  CGP::Points positions = CGP::Points::Zero(3, view.size_of_vertices());
  for (int v = 0; v < view.size_of_vertices(); ++v)
    positions.col(v).head<2>() << uv[graph.vertex(v)].x(), uv[graph.vertex(v)].y();
  CGP::Points upward = CGP::Points::Zero(3, view.size_of_faces());
  double area = 0;
  for (int f = 0; f < view.size_of_faces(); ++f) area += view.double_area_vector(f, positions).z();
  upward.row(2).setConstant(area < 0 ? -1 : 1);
  const CGP::Conformality map = CGP::conformality(view, positions, upward);
  const CGP::internal::Distribution uniform = CGP::distribution(
      CGP::quasi_conformal_errors(view, positions), Eigen::VectorXd::Ones(view.size_of_faces()));
  record.add("q_mean", map.quasi_conformal.mean).add("q_uniform", uniform.mean);
  record.add("q_p99", map.quasi_conformal.p99).add("q_max", map.quasi_conformal.max);
  record.add("cross_ratio", map.length_cross_ratio.rms).add("flips", map.flipped_faces);
  record.add("spread", map.scale.log_deviation);
}

void measure(const std::string& name, Surface& mesh, const Method& method)
{
  const Border border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  UV_map uv = mesh.add_property_map<Surface::Vertex_index, Kernel::Point_2>("v:uv").first;
  std::string status;
  double seconds = never, all = 0;
  const auto run = [&] {
    const double before = all;
    all += seconds_of([&] { status = method.run(mesh, border, uv); });
    seconds = std::min(seconds, all - before);
  };
  const double bytes = peak_bytes(run);
  for (int runs = 1; runs < most_runs && all < enough_seconds; ++runs) run();
  Record record = begin_record(name, mesh, method);
  record.add("status", status).add("seconds", seconds).add("megabytes", bytes / 1e6);
  judge(mesh, uv, record);
  record.print();
}

void run_in_a_process(const std::string& name, Surface& mesh, const Method& method)
{
  const pid_t child = fork();
  if (child == 0) {
    alarm(time_limit);
    try {
      measure(name, mesh, method);
    } catch (const std::exception& error) {
      begin_record(name, mesh, method).add("status", error.what()).print();
    }
    _exit(EXIT_SUCCESS);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status == 0) return;
  const bool is_late = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  begin_record(name, mesh, method)
      .add("status", std::string(is_late ? "not finished in ten minutes" : "crashed"))
      .print();
}

struct Options {
  std::vector<std::string> methods;  // all if there are none
  int cones = 0;
};

void compare(const std::string& name, Surface& mesh, const std::vector<Method>& methods,
             const std::vector<std::string>& wanted)
{
  for (const Method& method : methods)
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), method.name) != wanted.end())
      run_in_a_process(name, mesh, method);
}

void compare(const std::string& path, const Options& options)
{
  Surface mesh;
  if (!CGAL::IO::read_polygon_mesh(path, mesh)) throw std::runtime_error("cannot read " + path);
  std::vector<Method> methods = all_methods();
  if (options.cones == 0) return compare(name_of(path), mesh, methods, options.methods);
  Cut_surface cut(mesh, options.cones);
  const std::vector<Method> more = orbifold_methods(cut);
  methods.insert(methods.begin(), more.begin(), more.end());
  compare(name_of(path) + ", " + std::to_string(options.cones) + " cones", cut.disk, methods,
          options.methods);
}

}  // namespace

int main(int argc, char* argv[])
{
  try {
    Options options;
    for (int i = 1; i < argc; ++i)
      if (argv[i] == std::string("--method") && i + 1 < argc)
        options.methods.push_back(argv[++i]);
      else if (argv[i] == std::string("--cones") && i + 1 < argc)
        options.cones = std::stoi(argv[++i]);
      else
        compare(argv[i], options);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_parameterization: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
