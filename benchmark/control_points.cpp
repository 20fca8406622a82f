// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Moves one of ten control points of surfaces, by `Conformal_deformation` and by CGAL's
/// `Surface_mesh_deformation`, and drags it on in small steps. Prints a line of JSON for each mesh,
/// distance and method.
///
/// Usage: benchmark_control_points MESH...
///
/// A mesh is a file or the name of a shape: sphere, bumpy_sphere, torus, disk.
/// Meshes have the area 4 pi, so that the radius of the sphere of the same area is 1. The first
/// control point is the highest vertex, each next one as far as possible from those before. The
/// second is moved, the others are held.
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/spin/Conformal_deformation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#ifndef CGAL_EIGEN3_ENABLED
#define CGAL_EIGEN3_ENABLED
#endif
#include <CGAL/Surface_mesh_deformation.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "stage.h"
#include "support/Record.h"
#include "support/bounded_meshes.h"
#include "support/clock.h"
#include "support/control_points.h"
#include "support/spheres.h"
#include "support/surface_mesh.h"
#include "support/tori.h"
#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;
using CGP::internal::Control_point;
using Deformation = CGP::internal::Conformal_deformation;

const int count = 10;                  // of control points
const int drags = 10;                  // after the move
const double drag = 0.01;              // in radii, each
const double distances[] = {0.3, 1.};  // of the move, in radii

/// the mesh of a file, or of a shape of about 20,000 faces
CGP::Mesh_view surface_of(const std::string& name)
{
  if (name == "sphere") return in_unit_frame(cgp_test::icosphere(5));
  if (name == "bumpy_sphere") return in_unit_frame(bumpy_geodesic_sphere(32));
  if (name == "torus") return in_unit_frame(cgp_test::irregular_torus(2, 1, 140, 70));
  if (name == "disk") return in_unit_frame(cgp_test::jittered_disk(58, .1));
  return make_mesh(name);
}

/// the root mean square change of the angles between the normals of neighbouring faces, in degrees
double change_of_dihedral_angles(const CGP::Mesh_view& mesh, const CGP::Points& p)
{
  const CGP::Mesh_view moved(p, mesh.corners());
  const auto angle = [](const CGP::Mesh_view& m, int f, int g) {
    const Eigen::Vector3d a = m.double_area_vector(f), b = m.double_area_vector(g);
    return std::atan2(a.cross(b).norm(), a.dot(b));
  };
  double sum = 0;
  int interior = 0;
  for (int h = 0; h < 3 * mesh.size_of_faces(); ++h) {
    if (mesh.twin(h) < h) continue;  // at the boundary, or the other one
    const int f = CGP::Mesh_view::face(h), g = CGP::Mesh_view::face(mesh.twin(h));
    const double change = angle(moved, f, g) - angle(mesh, f, g);
    sum += change * change;
    ++interior;
  }
  return std::sqrt(sum / interior) * 180 / cgp_test::pi;
}

void describe(const CGP::Mesh_view& mesh, const CGP::Points& p,
              const std::vector<Control_point>& points, Record& record)
{
  const CGP::Conformality map =
      CGP::conformality(mesh, p, CGP::neighbourhood_normals({p, mesh.corners()}));
  const CGP::Points missed =
      CGP::internal::positions_of(points, p) - CGP::internal::targets_of(points);
  record.add("q_mean", map.quasi_conformal.mean).add("q_max", map.quasi_conformal.max);
  record.add("flips", map.flipped_faces).add("lengths", map.scale.log_deviation);
  record.add("scale_min", map.scale.min_scale).add("scale_max", map.scale.max_scale);
  record.add("missed", missed.colwise().norm().maxCoeff() / cgp_test::diagonal(mesh));
  record.add("dihedral", change_of_dihedral_angles(mesh, p));
}

class Comparison {
 public:
  explicit Comparison(const std::string& name)
      : m_name(std::filesystem::path(name).stem().string()),
        m_mesh(surface_of(name)),
        m_poisson(seconds_of_scalar_poisson(m_mesh))
  {}

  void move_conformally(double distance) const
  {
    const auto points = cgp_test::one_moved(m_mesh, count, distance);
    Deformation deformation(m_mesh);
    CGP::Spin_result result;
    const double seconds = seconds_of([&] { result = deformation.deform(points); });
    Record record = begun(distance, "conformal");
    describe(m_mesh, result.positions, points, record);
    record.add("reached", result.report.reached).add("seconds", seconds / m_poisson);
    record.add("factorizations", result.report.factorizations);
    record.add("solves", result.report.solves);
    if (result.report.reached == 1) add_drags(deformation, distance, record);
    record.print();
  }

  template <CGAL::Deformation_algorithm_tag algorithm>
  void move_rigidly(double distance, const std::string& way) const
  {
    Mesh mesh = surface_mesh(m_mesh);
    CGAL::Surface_mesh_deformation<Mesh, CGAL::Default, CGAL::Default, algorithm> deformation(mesh);
    for (const Vertex v : vertices(mesh)) deformation.insert_roi_vertex(v);
    const auto points = cgp_test::one_moved(m_mesh, count, distance);
    for (const Control_point& p : points) deformation.insert_control_vertex(vertex(p.vertices[0]));
    if (!deformation.preprocess()) throw std::runtime_error("cannot factor the matrix");
    const auto set_targets = [&](double length) {
      for (const Control_point& p : cgp_test::one_moved(m_mesh, count, length))
        deformation.set_target_position(vertex(p.vertices[0]), point(p.target));
    };
    set_targets(distance);
    const unsigned many = 200;
    const double seconds = seconds_of([&] { deformation.deform(many, 1e-6); });
    Record record = begun(distance, way);
    describe(m_mesh, positions(mesh), points, record);
    record.add("reached", 1.).add("seconds", seconds / m_poisson);
    const double dragged = seconds_of([&] {
      for (int i = 1; i <= drags; ++i) {
        set_targets(distance + i * drag);
        deformation.deform();
      }
    });
    record.add("drag_seconds", dragged / drags / m_poisson).print();
  }

 private:
  Record begun(double distance, const std::string& way) const
  {
    Record record;
    record.add("mesh", m_name).add("faces", m_mesh.size_of_faces());
    record.add("distance", distance).add("way", way);
    return record;
  }

  void add_drags(Deformation& deformation, double distance, Record& record) const
  {
    int factorizations = 0, solves = 0;
    double reached = 1;
    const double seconds = seconds_of([&] {
      for (int i = 1; i <= drags; ++i) {
        const CGP::Spin_report report =
            deformation.deform(cgp_test::one_moved(m_mesh, count, distance + i * drag)).report;
        factorizations += report.factorizations;
        solves += report.solves;
        reached = (std::min)(reached, report.reached);
      }
    });
    record.add("drag_seconds", seconds / drags / m_poisson);
    record.add("drag_factorizations", static_cast<double>(factorizations) / drags);
    record.add("drag_solves", static_cast<double>(solves) / drags).add("drag_reached", reached);
  }

  std::string m_name;
  CGP::Mesh_view m_mesh;
  double m_poisson;
};

}  // namespace

int main(int argc, char* argv[])
{
  try {
    for (int i = 1; i < argc; ++i) {
      const Comparison comparison(argv[i]);
      for (const double distance : distances) {
        comparison.move_conformally(distance);
        comparison.move_rigidly<CGAL::ORIGINAL_ARAP>(distance, "ARAP");
        comparison.move_rigidly<CGAL::SRE_ARAP>(distance, "SRE-ARAP");
      }
    }
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_control_points: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
