// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Compares fairing methods as in the thesis: each has the same solver, the same processor time,
/// and its largest stable time step, which is determined by a search. Prints lines of JSON for each
/// mesh: for the initial surface, and for the result of each method.
///
/// Usage: benchmark_fairing [--write FOLDER] MESH.off...
///        benchmark_fairing --against RESULT.off MESH.off
///        benchmark_fairing --check
///
/// Meshes are closed and have the area 4 pi. The processor time is that of the flow of this library
/// with time step 1 until its energy settles, at most twenty steps. With --against, a result on the
/// same faces is compared with the flows that go to the conformal map to the sphere. With --check
/// the methods are compared with known results in closed form.
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

#include "fairing/Method.h"
#include "fairing/Opponent.h"
#include "fairing/search_step.h"
#include "support/Record.h"
#include "support/clock.h"
#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;

const int steps_of_ours = 20;
const int shown_moments = 24;  // of a curve

/// the least angle of any face, in degrees
double least_angle(const CGP::Mesh_view& mesh)
{
  double greatest = -1;  // cosine
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    const Eigen::Vector3d a = mesh.vector(CGP::Mesh_view::next_in_face(h)),
                          b = -mesh.vector(CGP::Mesh_view::previous_in_face(h));
    greatest = std::max(greatest, a.dot(b) / (a.norm() * b.norm()));
  }
  return std::acos(std::min(greatest, 1.)) * 180 / cgp_test::pi;
}

/// moments evenly spaced in the logarithm of their number, as `seconds:energy ...`
std::string shown(const std::vector<Run::Moment>& curve)
{
  std::string text;
  double next = 1;
  const double growth =
      std::max(1.05, std::pow(static_cast<double>(curve.size()), 1. / shown_moments));
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (static_cast<double>(i + 1) < next && i + 1 < curve.size()) continue;
    next = static_cast<double>(i + 1) * growth;
    char moment[64];
    std::snprintf(moment, sizeof moment, "%.5g:%.6g ", curve[i].seconds, curve[i].energy);
    text += moment;
  }
  return text;
}

void write_off(const std::string& path, const CGP::Points& positions,
               const CGP::Mesh_view::Corners& corners)
{
  std::ofstream file(path);
  file << "OFF\n" << positions.cols() << ' ' << corners.size() << " 0\n";
  for (Eigen::Index v = 0; v < positions.cols(); ++v) file << positions.col(v).transpose() << '\n';
  for (const auto& [a, b, c] : corners) file << "3 " << a << ' ' << b << ' ' << c << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

class Comparison {
 public:
  Comparison(const std::string& path, std::string folder)
      : m_name(path.substr(path.rfind('/') + 1)),
        m_folder(std::move(folder)),
        m_initial(make_mesh(path))
  {
    m_name.resize(m_name.rfind('.'));
  }

  void run()
  {
    print("before", "", {});
    const Method ours{"ours", run_conformal_willmore};
    const Run run = run_method(ours, m_initial, 1, never, steps_of_ours);
    m_seconds = run.seconds();
    print("ours", "default", run);
    for (const Method& method : competing_methods()) {
      const Search search = search_step(method, m_initial, m_seconds);
      print(method.name, "stable", search.largest_stable.value_or(Run()));
      print(method.name, "lowest", search.lowest.value_or(Run()));
    }
  }

 private:
  void print(const std::string& method, const std::string& role, const Run& run) const
  {
    Record record;
    record.add("mesh", m_name).add("faces", m_initial.size_of_faces());
    record.add("method", method).add("role", role).add("budget", m_seconds);
    record.add("time_step", run.time_step).add("steps", run.steps);
    record.add("stable", static_cast<int>(run.is_stable)).add("seconds", run.seconds());
    record.add("q_worst", run.worst_q).add("end", run.end).add("curve", shown(run.curve));
    describe(run.positions.size() > 0 ? run.positions : m_initial.positions(), record);
    record.print();
    std::string file = m_name + "_" + method + (role.empty() ? "" : "_" + role) + ".off";
    std::replace(file.begin(), file.end(), ' ', '_');
    if (!m_folder.empty() && run.steps > 0)
      write_off(m_folder + "/" + file, run.positions, m_initial.corners());
    else if (!m_folder.empty() && role.empty())
      write_off(m_folder + "/" + file, m_initial.positions(), m_initial.corners());
  }

  void describe(const CGP::Points& positions, Record& record) const
  {
    const CGP::Mesh_view mesh(positions, m_initial.corners());
    const CGP::Conformality map =
        CGP::conformality(m_initial, positions, CGP::neighbourhood_normals(mesh));
    record.add("energy", CGP::willmore_energy(mesh));
    record.add("steiner_energy", CGP::steiner_willmore_energy(mesh));
    record.add("q_mean", map.quasi_conformal.mean).add("q_p99", map.quasi_conformal.p99);
    record.add("q_max", map.quasi_conformal.max);
    record.add("cross_ratio_rms", map.length_cross_ratio.rms);
    record.add("cross_ratio_max", map.length_cross_ratio.max);
    record.add("flips", map.flipped_faces).add("least_angle", least_angle(mesh));
  }

  std::string m_name, m_folder;
  CGP::Mesh_view m_initial;
  double m_seconds = 0;
};

}  // namespace

int main(int argc, char* argv[])
{
  try {
    if (argc == 2 && std::string(argv[1]) == "--check")
      return check_methods() ? EXIT_SUCCESS : EXIT_FAILURE;
    if (argc == 4 && std::string(argv[1]) == "--against") {
      compare_with_opponents(argv[3], argv[2]);
      return EXIT_SUCCESS;
    }
    const bool writes = argc > 2 && std::string(argv[1]) == "--write";
    for (int i = writes ? 3 : 1; i < argc; ++i) Comparison(argv[i], writes ? argv[2] : "").run();
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_fairing: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
