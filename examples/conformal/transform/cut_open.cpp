// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "cut_open.h"

#include "cut_graph.h"

#include "conformal/process/Failure.h"
#include "conformal/process/text.h"
#include "conformal/repair/separate_fans.h"

#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace conformal {
namespace {

using CGP::internal::Mesh_component;

int vertex_in_file(const Surface_input& input, const Mesh_component& component, int v)
{
  const auto in_mesh = static_cast<std::size_t>(component.vertices[static_cast<std::size_t>(v)]);
  return input.vertex_in_file[in_mesh];
}

/// All edges but the diagonals of polygons
Edge_set edges_of_file(const Surface_input& input, const Mesh_component& component)
{
  const auto polygon = [&](int h) {
    const int f = component.faces[static_cast<std::size_t>(CGP::Mesh_view::face(h))];
    return input.face_in_file[static_cast<std::size_t>(f)];
  };
  Edge_set edges;
  for (int k = 0; k < component.mesh.size_of_edges(); ++k) {
    const int h = *component.mesh.halfedges_begin(k);
    const int t = component.mesh.twin(h);
    edges.push_back(t < 0 || polygon(h) != polygon(t));
  }
  return edges;
}

/// At the boundary there are no cones.
void require_inside(const Surface_input& input, const Mesh_component& component,
                    const std::vector<Cone>& cones)
{
  const CGP::Mesh_view& mesh = component.mesh;
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    for (const Cone& cone : cones)
      if (mesh.twin(h) < 0 && mesh.from(h) == cone.vertex)
        throw unsuitable(
            input.file.path,
            "vertex " + std::to_string(vertex_in_file(input, component, cone.vertex)) +
                " is at the boundary, where the angle is free; try: others for --cones");
}

/// the given cones that lie on the component
std::vector<Cone> given_cones(const Surface_input& input, const Mesh_component& component,
                              const Cut_options& options)
{
  std::vector<Cone> found;
  for (int v = 0; v < component.mesh.size_of_vertices(); ++v) {
    const int i = vertex_in_file(input, component, v);
    const auto cone = std::find_if(options.cones.begin(), options.cones.end(),
                                   [i](const Cone& given) { return given.vertex == i; });
    if (cone != options.cones.end()) found.push_back({v, cone->defect});
  }
  const CGP::internal::Topology topology = CGP::topology(component.mesh);
  if (!topology.is_closed()) require_inside(input, component, found);
  const bool is_sphere = topology.is_sphere(),
             is_wanted = topology.is_closed() && !options.cones.empty();
  if (is_wanted && (found.empty() || (is_sphere && found.size() < 2)))
    throw unsuitable(input.file.path,
                     "--cones wants vertices of each closed component, two at least of a sphere; "
                     "try: --cut, which finds them");
  return found;
}

int inner_vertices(const CGP::Mesh_view& mesh)
{
  int count = mesh.size_of_vertices();
  for (const auto& loop : CGP::boundary_loops(mesh)) count -= static_cast<int>(loop.size());
  return count;
}

/// The cuts of a component, and the metric that it gets
class Opening {
 public:
  Opening(const Surface_input& input, const Mesh_component& component, const Cut_options& options)
      : m_input(input), m_component(component), m_ways(edges_of_file(input, component))
  {
    const std::vector<Cone> given = given_cones(input, component, options);
    if (options.makes_flat)
      flatten(given, options);
    else if (given.empty())
      m_ends = find_tips(component.mesh, std::max(options.tips, 2), m_ways);
    for (const Cone& cone : options.makes_flat ? m_cones : given) m_ends.push_back(cone.vertex);
  }

  void add_cut(std::vector<Corner_fans::Edge>& cuts) const
  {
    const CGP::Mesh_view& mesh = m_component.mesh;
    const Edge_set cut = cut_graph(mesh, m_ends, m_ways);
    for (int k = 0; k < mesh.size_of_edges(); ++k) {
      if (!cut[static_cast<std::size_t>(k)]) continue;
      const auto [a, b] = std::minmax({in_file(mesh.ends(k)[0]), in_file(mesh.ends(k)[1])});
      cuts.push_back({a, b});
    }
  }

  /// \param log_scale of each vertex of the file
  void add_metric(std::vector<double>& log_scale, std::vector<Cone>& cones) const
  {
    for (int v = 0; v < m_log_scale.size(); ++v)
      log_scale[static_cast<std::size_t>(in_file(v))] = m_log_scale[v];
    for (const Cone& cone : m_cones) cones.push_back({in_file(cone.vertex), cone.defect});
  }

 private:
  int in_file(int v) const { return vertex_in_file(m_input, m_component, v); }

  void flatten(const std::vector<Cone>& given, const Cut_options& options)
  {
    const CGP::Mesh_view& mesh = m_component.mesh;
    const CGP::internal::Topology topology = CGP::topology(mesh);
    const int least = topology.is_sphere() ? 3 : topology.is_closed() ? 1 : 0;
    const int count =
        given.empty() ? std::max(options.tips, least) : static_cast<int>(given.size());
    if (count < least)
      throw unsuitable(m_input.file.path,
                       "a sphere that is flat outside its cones has three at least");
    CGP::internal::Cone_metric metric =
        CGP::internal::place_cones(mesh, std::min(count, inner_vertices(mesh)), given);
    require_angles(metric.cones);
    m_cones = std::move(metric.cones);
    m_log_scale = std::move(metric.log_scale);
  }

  /// Angles that are given may not fit the surface [Gauss and Bonnet], or leave none for the
  /// others.
  void require_angles(const std::vector<Cone>& cones) const
  {
    const double degrees = 180 / std::acos(-1.);
    const double wanted = 360 * CGP::topology(m_component.mesh).euler_characteristic();
    double sum = 0;
    for (const Cone& cone : cones) {
      sum += *cone.defect * degrees;
      if (*cone.defect * degrees >= 360 - 1e-6)
        throw unsuitable(m_input.file.path, "the cones leave no angle for vertex " +
                                                std::to_string(in_file(cone.vertex)) +
                                                "; try: more cones, or other angles");
    }
    if (!CGP::topology(m_component.mesh).is_closed() || std::abs(sum - wanted) < 1e-6) return;
    throw unsuitable(m_input.file.path,
                     "what the angles of the cones lack of 360 degrees adds up to " +
                         text_of(sum, 8) + ", wanted " + text_of(wanted, 8) +
                         "; try: no angle for one of them");
  }

  const Surface_input& m_input;
  const Mesh_component& m_component;
  Edge_set m_ways;
  std::vector<int> m_ends;
  std::vector<Cone> m_cones;
  Eigen::VectorXd m_log_scale;
};

/// What was known of the vertices of the file before, at those of the mesh
Eigen::VectorXd at_copies(const std::vector<double>& values, const Cut_surface& surface)
{
  Eigen::VectorXd result(surface.input.mesh.size_of_vertices());
  for (int v = 0; v < result.size(); ++v) {
    const int copy = surface.input.vertex_in_file[static_cast<std::size_t>(v)];
    result[v] = values[static_cast<std::size_t>(surface.origin[static_cast<std::size_t>(copy)])];
  }
  return result;
}

}  // namespace

Cut_surface cut_along(Surface_file file, std::vector<Corner_fans::Edge> cuts)
{
  std::sort(cuts.begin(), cuts.end());
  Cut_surface surface;
  const Corner_fans fans(file.polygons, cuts);
  surface.origin = separate_fans(file, fans).vertex_in_file;
  surface.input = prepare(std::move(file));
  return surface;
}

Cut_surface cut_open(const Surface_input& input, const Cut_options& options)
{
  std::vector<Corner_fans::Edge> cuts;
  std::vector<double> log_scale(input.file.points.size(), 0);
  std::vector<Cone> cones;
  for (const Mesh_component& component : CGP::mesh_components(input.mesh)) {
    const bool is_closed = CGP::topology(component.mesh).is_closed();
    if (is_closed ? !options.opens_closed() : !options.makes_flat) continue;
    const Opening opening(input, component, options);
    opening.add_cut(cuts);
    opening.add_metric(log_scale, cones);
  }
  Cut_surface surface = cut_along(input.file, std::move(cuts));
  surface.cones = std::move(cones);
  if (options.makes_flat) surface.log_scale = at_copies(log_scale, surface);
  return surface;
}

}  // namespace conformal
