// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Framed_surface.h>

#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <utility>

namespace Conformal_geometry_processing::internal {

Framed_surface::Framed_surface(const Mesh_view& mesh, std::optional<double> mollification)
    : m_positions(mesh.positions()),
      m_frame(m_positions),
      m_mesh(mesh),
      m_mollification(mollification.value_or(0))
{
  m_mesh.set_positions(m_frame.to_frame(m_positions));
  if (!mollification) return;
  m_view.emplace(m_mesh, *mollification, forms());
  m_measured = well_shaped_faces(m_mesh);
}

void Framed_surface::require(const Mesh_view& mesh, std::optional<double> mollification,
                             const std::string& function)
{
  if (!mollification) return require_surface(mesh, function);
  require_manifold(mesh, function);
  require_some_area(mesh, function);
  if (!(*mollification > 0 && *mollification < 1))
    throw Precondition_error(function, "a mollification of " + std::to_string(*mollification) +
                                           "; a number between 0 and 1 is needed");
}

void Framed_surface::require_faces(const Mesh_view& mesh, bool is_mollified,
                                   const std::string& function)
{
  require_finite_positions(mesh, function);
  if (is_mollified)
    require_some_area(mesh, function);
  else
    require_positive_areas(mesh, function);
}

bool Framed_surface::has_loops() const
{
  const int chi = m_mesh.size_of_vertices() - m_mesh.size_of_edges() + m_mesh.size_of_faces();
  return chi < 1;  // a sphere has 2, a disk 1
}

Eigen::MatrixXd Framed_surface::forms() const
{
  if (m_view) return m_view->forms();
  return has_loops() ? closed_generators(m_mesh) : Eigen::MatrixXd(m_mesh.size_of_edges(), 0);
}

void Framed_surface::set_positions(const Points& positions)
{
  m_positions = positions;
  m_frame = Normalized_frame(positions);
  m_mesh.set_positions(m_frame.to_frame(positions));
}

Surface_ref Framed_surface::surface() const
{
  if (m_view) return *m_view;
  return m_mesh;
}

Boundary_condition Framed_surface::in_frame(Boundary_condition condition) const
{
  if (condition.kind == Boundary_condition::Kind::positions)
    condition.targets = m_frame.to_frame(std::move(condition.targets));
  return condition;
}

Spin_report::Mollification Framed_surface::mollification() const
{
  if (!m_view) return {};
  const bool is_longer = m_view->added_length() > 0;
  return {m_mollification,
          m_view->number_of_thin_faces(),
          is_longer ? m_mesh.size_of_edges() : 0,
          m_view->added_length() * unit(),
          m_view->number_of_flips(),
          m_measured->mesh.size_of_faces(),
          m_measured->share};
}

}  // namespace Conformal_geometry_processing::internal
