// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// How near do conformal deformations come to bends and twists? Prints a line of JSON for each
// closed mesh and motion.
//
// usage: benchmark_nearest NAME.off ...
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>

#include "support/Off_file.h"
#include "support/Record.h"
#include "support/potentials.h"

namespace {

using namespace cgp_benchmark;

const double angle = std::acos(-1.) / 3;

/// the least distance of a vertex from the middle of the bounding box by the largest: 1 for spheres
double roundness(const CGP::Points& p)
{
  const Eigen::Vector3d middle = (p.rowwise().minCoeff() + p.rowwise().maxCoeff()) / 2;
  const Eigen::RowVectorXd distances = (p.colwise() - middle).colwise().norm();
  return distances.minCoeff() / distances.maxCoeff();
}

/// bends a surface towards its second longest extent, or twists it about its longest one, by 60
/// degrees from end to end
CGP::Points moved(const CGP::Mesh_view& mesh, bool is_bend)
{
  const Eigen::Vector3d low = mesh.positions().rowwise().minCoeff(),
                        high = mesh.positions().rowwise().maxCoeff(), extent = high - low;
  std::array<int, 3> axis = {0, 1, 2};
  std::stable_sort(axis.begin(), axis.end(), [&](int a, int b) { return extent[a] > extent[b]; });
  const auto [a, b, c] = axis;
  const double radius = extent[a] / angle;
  CGP::Points p = mesh.positions().colwise() - (low + high) / 2;
  for (Eigen::Index v = 0; v < p.cols(); ++v) {
    const Eigen::Vector3d d = p.col(v);
    const double turn = d[a] / radius, cos = std::cos(turn), sin = std::sin(turn);
    if (is_bend) {
      p(a, v) = (radius - d[b]) * sin;
      p(b, v) = radius - (radius - d[b]) * cos;
    } else {
      p(b, v) = cos * d[b] - sin * d[c];
      p(c, v) = sin * d[b] + cos * d[c];
    }
  }
  return p;
}

CGP::Nearest_spin_result nearest(const CGP::Mesh_view& mesh, const CGP::Points& target,
                                 const CGP::Nearest_spin_options& options = {})
{
  CGP::Nearest_spin_transformation transformation(mesh, target, "benchmark_nearest", options);
  return transformation.transform();
}

void add(const CGP::Nearest_spin_result& found, const CGP::Mesh_view& mesh,
         const std::string& prefix, Record& record)
{
  const CGP::Spin_report& report = found.report;
  const auto scales = CGP::internal::measured_scales(found.lambda, CGP::vertex_areas(mesh), {});
  record.add(prefix + "verified", report ? 1 : 0)
      .add(prefix + "fault", to_string(report.fault()))
      .add(prefix + "distance", found.distance)
      .add(prefix + "normals", found.normal_distance / found.source_normal_distance)
      .add(prefix + "Q", report.conformality.quasi_conformal.mean)
      .add(prefix + "low", scales.low)
      .add(prefix + "high", scales.high)
      .add(prefix + "factorizations", report.factorizations)
      .add(prefix + "solves", report.solves);
}

void survey(const std::string& path)
{
  const CGP::Mesh_view mesh = normalized(read_off(path));
  CGP::require_surface(mesh, "benchmark_nearest");
  CGP::require_closed(mesh, "benchmark_nearest");
  const int chi = mesh.size_of_vertices() - mesh.size_of_edges() + mesh.size_of_faces();
  for (const bool is_bend : {true, false}) {
    const CGP::Points target = moved(mesh, is_bend);
    const CGP::Nearest_spin_result found = nearest(mesh, target);
    CGP::Nearest_spin_options curvature, positions;
    curvature.keep_curvature = true;
    positions.normal_weight = 0;
    Record record;
    record.add("mesh", path.substr(path.find_last_of('/') + 1))
        .add("faces", mesh.size_of_faces())
        .add("genus", 1 - chi / 2)
        .add("roundness", roundness(mesh.positions()))
        .add("motion", is_bend ? "bend" : "twist")
        .add("target_Q", CGP::quasi_conformal_error(mesh, target).mean)
        .add("source_distance", found.source_distance);
    add(nearest(mesh, target, curvature), mesh, "curvature_", record);
    add(nearest(mesh, target, positions), mesh, "positions_", record);
    add(found, mesh, "", record);
    record.print();
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv)
{
  for (int k = 1; k < argc; ++k) try {
      survey(argv[k]);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: left out: %s\n", argv[k], e.what());
    }
}
