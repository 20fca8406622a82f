// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "convergence/closed_forms.h"
#include "convergence/irregular_meshes.h"
#include "convergence/measurements.h"
#include "support/Record.h"

namespace cgp_benchmark {
namespace {

namespace CGP = Conformal_geometry_processing;
using CGP::Boundary_condition;
using CGP::Mesh_view;

/// one smooth problem on meshes of growing size
struct Space_case {
  std::string surface, mesh, potential;
  std::vector<int> sizes;
  std::function<Mesh_view(int)> make;
  std::function<double(const Point&)> rho;
  std::function<Point(const Point&)> image = {};  ///< up to similarity; empty if it is not known
  std::function<double(const Point&)> curvature = {};  ///< H of the surface; empty if not measured
  Boundary_condition condition = {};
};

Eigen::VectorXd values_of(const std::function<double(const Point&)>& f, const Mesh_view& mesh)
{
  Eigen::VectorXd values(mesh.size_of_vertices());
  for (int v = 0; v < values.size(); ++v) values[v] = f(mesh.position(v));
  return values;
}

CGP::Points exact_positions(const Space_case& c, const Mesh_view& mesh)
{
  CGP::Points p = mesh.positions();
  for (int v = 0; v < mesh.size_of_vertices(); ++v) p.col(v) = c.image(mesh.position(v));
  return p;
}

/// | found - expected | / | expected | in L2
double relative_error(const Mesh_view& mesh, const Eigen::VectorXd& found,
                      const Eigen::VectorXd& expected)
{
  const Eigen::VectorXd areas = CGP::voronoi_areas(mesh);
  return std::sqrt(areas.dot((found - expected).cwiseAbs2()) / areas.dot(expected.cwiseAbs2()));
}

/// \brief Adds the error of H~ |lambda|^2 = H + rho + gamma, where H is known, and the error of the
/// mean curvature of the mesh before the transformation
void add_curvature(Record& record, const Space_case& c, const Mesh_view& mesh,
                   const Eigen::VectorXd& rho, const CGP::Spin_result& result)
{
  const Eigen::VectorXd H = values_of(c.curvature, mesh);
  Eigen::VectorXd found = CGP::mean_curvature(CGP::Mesh_view(result.positions, mesh.corners()));
  for (int v = 0; v < found.size(); ++v) found[v] *= squared_norm(result.lambda[v]);
  const Eigen::VectorXd expected = (H + rho).array() + result.report.eigenvalue;
  record.add("curvature", relative_error(mesh, found, expected));
  record.add("source_curvature", relative_error(mesh, CGP::mean_curvature(mesh), H));
}

void add(Record& record, const std::string& prefix, const CGP::internal::Distribution& q,
         const CGP::internal::Length_cross_ratio_change& cross_ratio)
{
  record.add(prefix + "q_mean", q.mean - 1).add(prefix + "q_p99", q.p99 - 1);
  record.add(prefix + "q_max", q.max - 1);
  record.add(prefix + "ratio_rms", cross_ratio.rms).add(prefix + "ratio_max", cross_ratio.max);
}

void measure(const Space_case& c, int size)
{
  const Mesh_view mesh = c.make(size);
  const Eigen::VectorXd rho = values_of(c.rho, mesh);
  const CGP::Spin_result result = CGP::Spin_transformation(mesh, {c.condition, std::nullopt})
                                      .transform(CGP::Curvature_potential::on_vertices(rho));
  if (!result.report) throw std::runtime_error(c.surface + ", " + c.mesh + ": not found");

  Record record;
  record.add("table", "space").add("surface", c.surface).add("mesh", c.mesh);
  record.add("potential", c.potential).add("faces", mesh.size_of_faces());
  record.add("h", cgp_test::mean_edge_length(mesh)).add("gamma", result.report.eigenvalue);
  record.add("closure", result.report.closure_residual);
  record.add("flips", result.report.conformality.flipped_faces);
  add(record, "", result.report.conformality.quasi_conformal,
      result.report.conformality.length_cross_ratio);
  if (c.image) {
    const CGP::Points exact = exact_positions(c, mesh);
    record.add("shape", CGP::align(result.positions, exact).rms);
    add(record, "exact_", CGP::quasi_conformal_error(mesh, exact),
        CGP::length_cross_ratio_change(mesh, exact));
  }
  if (c.curvature) add_curvature(record, c, mesh, rho, result);
  record.print();
}

std::vector<Space_case> closed_surfaces()
{
  const std::vector<int> levels = {2, 3, 4, 5, 6}, fine = {3, 4, 5, 6}, points = {32, 64, 128, 256};
  const Inversion near_ellipsoid{{0.5, 0.4, 1.6}}, near_torus{{1, 1, 2.5}};
  const auto ellipsoid_rho = [=](const Point& p) {
    return near_ellipsoid.rho(p, normal_of_ellipsoid(p));
  };
  const auto torus_rho = [=](const Point& p) { return near_torus.rho(p, normal_of_torus(p)); };
  const auto ellipsoid_image = [=](const Point& p) { return near_ellipsoid.image(p); };
  const auto torus_image = [=](const Point& p) { return near_torus.image(p); };
  const auto ellipsoid_of = [](Mesh_view (*sphere)(int)) {
    return [=](int level) { return cgp_test::mapped(sphere(level), on_ellipsoid); };
  };
  const auto smooth = cgp_test::rho_of_section_3;
  const auto one = [](const Point&) { return 1.; };
  return {{"sphere", "regular", "smooth", levels, cgp_test::icosphere, smooth, {}, one},
          {"sphere", "irregular", "smooth", levels, irregular_sphere, smooth, {}, one},
          {"ellipsoid", "regular", "inversion", fine, ellipsoid_of(cgp_test::icosphere),
           ellipsoid_rho, ellipsoid_image, curvature_of_ellipsoid},
          {"ellipsoid", "irregular", "inversion", fine, ellipsoid_of(irregular_sphere),
           ellipsoid_rho, ellipsoid_image, curvature_of_ellipsoid},
          {"torus", "regular", "inversion", points, regular_torus, torus_rho, torus_image},
          {"torus", "irregular", "inversion", points, irregular_torus, torus_rho, torus_image}};
}

std::vector<Space_case> disks()
{
  const std::vector<int> rings = {16, 32, 64, 128};
  const double c = 2;
  const auto constant = [=](const Point&) { return c; };
  const auto image = [=](const Point& p) { return image_of_disk(p, c); };
  const std::pair<const char*, Mesh_view (*)(int)> meshes[] = {
      {"uniform", cgp_test::disk},
      {"nonuniform", cgp_test::moved_disk},
      {"irregular", irregular_disk},
      {"irregular inside", irregular_inside_disk}};
  const auto free = Boundary_condition::free(), tangents = Boundary_condition::tangents();
  std::vector<Space_case> list;
  for (const auto& [mesh, make] : meshes) {
    list.push_back({"disk, free", mesh, "bump", rings, make, bump, {}, {}, free});
    list.push_back({"disk, tangents", mesh, "bump", rings, make, bump, {}, {}, tangents});
    list.push_back(
        {"disk, tangents", mesh, "constant", rings, make, constant, image, {}, tangents});
  }
  return list;
}

}  // namespace

void measure_convergence_in_space()
{
  for (const auto& cases : {closed_surfaces(), disks()})
    for (const Space_case& c : cases)
      for (const int size : c.sizes) measure(c, size);
}

}  // namespace cgp_benchmark
