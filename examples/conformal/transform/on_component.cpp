// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Component.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace conformal {
namespace {

/// of some elements of the whole surface the numbers in the component, -1 for others
std::vector<int> numbers_in(const std::vector<int>& elements, int whole)
{
  std::vector<int> numbers(static_cast<std::size_t>(whole), -1);
  for (std::size_t k = 0; k < elements.size(); ++k)
    numbers[static_cast<std::size_t>(elements[k])] = static_cast<int>(k);
  return numbers;
}

/// the curves that are on the component, in its numbers
std::vector<std::vector<int>> curves_on_component(std::vector<std::vector<int>> curves,
                                                  const std::vector<int>& numbers)
{
  std::vector<std::vector<int>> own;
  for (std::vector<int>& curve : curves) {
    for (int& v : curve) v = numbers[static_cast<std::size_t>(v)];
    if (curve.front() >= 0) own.push_back(std::move(curve));
  }
  return own;
}

}  // namespace

CGP::Curvature_potential on_component(const CGP::Curvature_potential& rho,
                                      const Component& component, double factor)
{
  const bool on_faces = rho.on == CGP::Curvature_potential::On::faces;
  return {rho.on, factor * rho.values(on_faces ? component.faces : component.vertices)};
}

CGP::Boundary_condition on_component(const CGP::Boundary_condition& condition,
                                     const CGP::Mesh_view& whole, const Component& component)
{
  CGP::Boundary_condition own = condition;
  if (condition.targets.cols() == 0) return own;
  const int size = whole.size_of_vertices();
  own.curves = curves_on_component(condition.curves, numbers_in(component.vertices, size));
  const std::vector<int> number = numbers_in(CGP::frames_of(whole, condition).vertices, size);
  std::vector<int> columns;
  for (const int v : CGP::frames_of(component.input.mesh, own).vertices) {
    const int in_whole = component.vertices[static_cast<std::size_t>(v)];
    columns.push_back(number[static_cast<std::size_t>(in_whole)]);
  }
  own.targets = condition.targets(Eigen::indexing::all, columns);
  if (condition.normals.cols() > 0) own.normals = condition.normals(Eigen::indexing::all, columns);
  return own;
}

CGP::Mesh_view on_component(const CGP::Mesh_view& other, const Component& component)
{
  CGP::Mesh_view own = component.input.mesh;
  own.set_positions(other.positions()(Eigen::indexing::all, component.vertices));
  return own;
}

}  // namespace conformal
