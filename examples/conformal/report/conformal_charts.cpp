// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal_charts.h"

#include "face_regions.h"
#include "mesh_piece.h"
#include "solve_flat.h"

#include "conformal/process/at.h"

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace conformal {
namespace {

CGP::Points seen_along_normal(const CGP::Mesh_view& mesh)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (int f = 0; f < mesh.size_of_faces(); ++f) normal += mesh.double_area_vector(f);
  const auto turn = Eigen::Quaterniond::FromTwoVectors(normal, Eigen::Vector3d::UnitZ());
  return turn.toRotationMatrix() * mesh.positions();
}

CGP::Points flattened(const CGP::Mesh_view& mesh)
{
  try {
    const auto [z, report] = solve_flat(mesh, {}, "html");
    if (report) return CGP::in_space(z);
  } catch (const CGP::Precondition_error&) {
  } catch (const CGP::Solver_error&) {
  }
  return seen_along_normal(mesh);
}

/// the turn of the plane that makes the mean gradient of y over a flat piece point up
Eigen::Rotation2Dd upright(const CGP::Mesh_view& mesh, const CGP::Points& flat)
{
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    // Twice the area times the gradient: for each corner its y times the edge opposite, turned.
    const Eigen::Vector2d e = (flat.col(mesh.to(h)) - flat.col(mesh.from(h))).head<2>();
    const double y = mesh.position(mesh.corners(h / 3)[at(h % 3)]).y();
    gradient += y * Eigen::Vector2d(-e.y(), e.x());
  }
  return Eigen::Rotation2Dd(std::acos(0.) - std::atan2(gradient.y(), gradient.x()));
}

bool lies_in_plane_as_a_whole(const CGP::Mesh_view& mesh)
{
  const auto t = CGP::topology(mesh);
  return t.components == 1 && t.genus == 0 && !t.is_closed();
}

}  // namespace

Corner_places conformal_charts(const CGP::Mesh_view& mesh)
{
  const int most = 16, faces_of_one = 40;
  const int count =
      lies_in_plane_as_a_whole(mesh) ? 1 : std::clamp(mesh.size_of_faces() / faces_of_one, 4, most);
  const std::vector<int> region = face_regions(mesh, count);
  std::vector<std::vector<int>> faces(at(*std::max_element(region.begin(), region.end()) + 1));
  for (int f = 0; f < mesh.size_of_faces(); ++f) faces[at(region[at(f)])].push_back(f);
  Corner_places places(3 * region.size());
  for (std::vector<int>& some : faces) {
    const Mesh_piece piece = mesh_piece(mesh, std::move(some), region);
    const CGP::Points flat = flattened(piece.mesh);
    const Eigen::Rotation2Dd turn = upright(piece.mesh, flat);
    for (std::size_t k = 0; k < piece.faces.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector2d p = turn * flat.col(piece.mesh.corners()[k][i]).head<2>();
        places[3 * at(piece.faces[k]) + i] = {p.x(), p.y()};
      }
  }
  return places;
}

}  // namespace conformal
