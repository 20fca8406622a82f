// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Moves handles of surfaces by CGAL's `Surface_mesh_deformation` (as rigid as possible), and
/// computes the nearest spin transformation of the result: compares the preservation of angles and
/// lengths, and the positions of the handles. Prints a line of JSON for each mesh, motion and
/// method.
///
/// Usage: benchmark_deformers [--write FOLDER] MESH.off...
///
/// Meshes have the area 4 pi. The first 15 % of the longest extent are fixed; the last 15 % are
/// bent towards the second longest, like the end of a rod of constant curvature, or twisted.
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/nearest_spin_transform.h>

#include <Eigen/Geometry>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#ifndef CGAL_EIGEN3_ENABLED
#define CGAL_EIGEN3_ENABLED
#endif
#include <CGAL/Surface_mesh_deformation.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

#include "support/Record.h"
#include "support/clock.h"
#include "support/surface_mesh.h"
#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;

const double share_of_handles = 0.15;
const int substeps = 12;  // of every motion, as a hand would make it
const unsigned substep_iterations = 10, last_iterations = 200;
const double last_tolerance = 1e-6;  // of the energy

struct Motion {
  std::string name;
  double degrees;
};
const Motion motions[] = {{"bend", 30}, {"bend", 60}, {"bend", 90}, {"bend", 150}, {"twist", 60}};

/// the vertices at both ends of a surface, and where they go
class Handles {
 public:
  explicit Handles(const CGP::Mesh_view& mesh) : m_low(mesh.positions().rowwise().minCoeff())
  {
    const Eigen::Vector3d high = mesh.positions().rowwise().maxCoeff(), extent = high - m_low;
    std::array<int, 3> axis = {0, 1, 2};
    std::sort(axis.begin(), axis.end(), [&](int a, int b) { return extent[a] > extent[b]; });
    m_along = Eigen::Vector3d::Unit(axis[0]);
    m_aside = Eigen::Vector3d::Unit(axis[1]);
    m_begin = (m_low + high) / 2;
    m_begin[axis[0]] = m_low[axis[0]] + share_of_handles * extent[axis[0]];
    m_length = (1 - 2 * share_of_handles) * extent[axis[0]];
    for (int v = 0; v < mesh.size_of_vertices(); ++v) {
      const double s = m_along.dot(mesh.position(v) - m_begin);
      if (s < 0) m_held.push_back(v);
      if (s > m_length) m_moved.push_back(v);
    }
  }

  const std::vector<int>& held() const { return m_held; }
  const std::vector<int>& moved() const { return m_moved; }

  /// where a moved vertex goes after a share of the motion
  Eigen::Vector3d target(const Eigen::Vector3d& p, const Motion& motion, double t) const
  {
    const double angle = t * motion.degrees * cgp_test::pi / 180;
    const Eigen::Vector3d end = m_begin + m_length * m_along;
    if (motion.name == "twist") return end + Eigen::AngleAxisd(angle, m_along) * (p - end);
    const double radius = m_length / angle;
    const Eigen::Vector3d bent_end =
        m_begin + radius * std::sin(angle) * m_along + radius * (1 - std::cos(angle)) * m_aside;
    return bent_end + Eigen::AngleAxisd(angle, m_along.cross(m_aside)) * (p - end);
  }

 private:
  Eigen::Vector3d m_low, m_along, m_aside, m_begin;
  double m_length;
  std::vector<int> m_held, m_moved;
};

void deform_as_rigidly_as_possible(Mesh& mesh, const CGP::Mesh_view& initial,
                                   const Handles& handles, const Motion& motion)
{
  CGAL::Surface_mesh_deformation<Mesh> deformation(mesh);
  for (const Vertex v : vertices(mesh)) deformation.insert_roi_vertex(v);
  for (const int v : handles.held()) deformation.insert_control_vertex(vertex(v));
  for (const int v : handles.moved()) deformation.insert_control_vertex(vertex(v));
  if (!deformation.preprocess())
    throw std::runtime_error("Surface_mesh_deformation cannot factor its matrix");
  for (int i = 1; i <= substeps; ++i) {
    const double t = static_cast<double>(i) / substeps;
    for (const int v : handles.moved())
      deformation.set_target_position(vertex(v),
                                      point(handles.target(initial.position(v), motion, t)));
    if (i < substeps)
      deformation.deform(substep_iterations, 0);
    else
      deformation.deform(last_iterations, last_tolerance);
  }
}

/// the root mean square distance of the handles from where they are to be, by the diagonal
double missed(const CGP::Mesh_view& initial, const CGP::Points& positions, const Handles& handles,
              const Motion& motion)
{
  double sum = 0;
  for (const int v : handles.held()) sum += (positions.col(v) - initial.position(v)).squaredNorm();
  for (const int v : handles.moved())
    sum += (positions.col(v) - handles.target(initial.position(v), motion, 1)).squaredNorm();
  const Eigen::Vector3d diagonal =
      initial.positions().rowwise().maxCoeff() - initial.positions().rowwise().minCoeff();
  return std::sqrt(sum / static_cast<double>(handles.held().size() + handles.moved().size())) /
         diagonal.norm();
}

void describe(const CGP::Mesh_view& initial, const CGP::Points& positions, Record& record)
{
  const CGP::Conformality map = CGP::conformality(
      initial, positions, CGP::neighbourhood_normals({positions, initial.corners()}));
  record.add("q_mean", map.quasi_conformal.mean).add("q_p99", map.quasi_conformal.p99);
  record.add("q_max", map.quasi_conformal.max).add("flips", map.flipped_faces);
  record.add("cross_ratio_rms", map.length_cross_ratio.rms);
  record.add("cross_ratio_max", map.length_cross_ratio.max);
  record.add("scale_deviation", map.scale.log_deviation);
  record.add("scale_min", map.scale.min_scale).add("scale_max", map.scale.max_scale);
}

void write_off(const std::string& path, const Mesh& mesh)
{
  std::ofstream file(path);
  file.precision(17);
  if (!CGAL::IO::write_OFF(file, mesh)) throw std::runtime_error("cannot write " + path);
}

class Comparison {
 public:
  Comparison(const std::string& path, std::string folder)
      : m_name(path.substr(path.rfind('/') + 1)),
        m_folder(std::move(folder)),
        m_initial(make_mesh(path)),
        m_handles(m_initial)
  {
    m_name.resize(m_name.rfind('.'));
    write("initial", surface_mesh(m_initial));
  }

  void compare(const Motion& motion) const
  {
    Mesh rigid = surface_mesh(m_initial);
    double seconds =
        seconds_of([&] { deform_as_rigidly_as_possible(rigid, m_initial, m_handles, motion); });
    print(motion, "as rigid as possible", rigid, 0, seconds);

    const std::pair<double, const char*> blends[] = {
        {0, "nearest conformal"}, {0.5, "half way"}, {1, "spins integrated"}};
    for (const auto& [blend, way] : blends) {
      Mesh mesh = surface_mesh(m_initial);
      CGP::Nearest_spin_report report;
      CGP::Nearest_spin_options fit;
      fit.keep_curvature = true;
      seconds = seconds_of([&] {
        report = CGP::nearest_spin_transform(mesh, rigid.points(),
                                             CGP::parameters::blend(blend).fit(fit));
      });
      if (!report) throw std::runtime_error(m_name + ": no nearest spin transformation found");
      print(motion, way, mesh, report.distance, seconds);
    }
  }

 private:
  void print(const Motion& motion, const std::string& way, const Mesh& mesh, double distance,
             double seconds) const
  {
    const CGP::Points p = positions(mesh);
    Record record;
    record.add("mesh", m_name).add("faces", m_initial.size_of_faces());
    record.add("motion", motion.name).add("degrees", motion.degrees).add("way", way);
    describe(m_initial, p, record);
    record.add("distance", distance).add("missed", missed(m_initial, p, m_handles, motion));
    record.add("seconds", seconds).print();
    write(motion.name + "_" + std::to_string(std::lround(motion.degrees)) + "_" +
              way.substr(0, way.find(' ')),
          mesh);
  }

  void write(const std::string& what, const Mesh& mesh) const
  {
    if (!m_folder.empty()) write_off(m_folder + "/" + m_name + "_" + what + ".off", mesh);
  }

  std::string m_name, m_folder;
  CGP::Mesh_view m_initial;
  Handles m_handles;
};

}  // namespace

int main(int argc, char* argv[])
{
  try {
    const bool writes = argc > 2 && std::string(argv[1]) == "--write";
    for (int i = writes ? 3 : 1; i < argc; ++i) {
      const Comparison comparison(argv[i], writes ? argv[2] : "");
      for (const Motion& motion : motions) comparison.compare(motion);
    }
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_deformers: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
