// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/spin_structure.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Framed_surface.h>
#include <Quaternionic_linear_algebra/algebra/rotor.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

bool turns_evenly(const Mesh_view& mesh, const internal::Face_loop& loop)
{
  const auto middle = [&](int h) -> Eigen::Vector3d {
    return (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))) / 2;
  };
  const auto normal = [&](int h) -> Eigen::Vector3d {
    return mesh.double_area_vector(Mesh_view::face(h)).normalized();
  };
  const std::size_t n = loop.size();
  Quaternion<double> turned{1, 0, 0, 0};  // conjugate(turned) v turned
  for (std::size_t k = 0; k < n; ++k) {
    const int before = loop[(k + n - 1) % n], here = loop[k], after = loop[(k + 1) % n];
    // Turns about the edge into the next face, then about its normal: both by less than half a
    // turn.
    const Quaternion<double> hinge = rotor(normal(here), normal(after));
    const Eigen::Vector3d arriving = spin(hinge, middle(here) - middle(before)).normalized();
    turned = turned * hinge * rotor(arriving, (middle(after) - middle(here)).normalized().eval());
  }
  return turned.w > 0;
}

internal::Spin_structure spin_structure(const Mesh_view& mesh)
{
  internal::Spin_structure s;
  const std::vector<internal::Face_loop> loops = loops_of_faces(mesh);
  for (const internal::Face_loop& loop : loops)
    s.values.push_back(turns_evenly(mesh, loop) ? 1 : 0);
  s.crossings = crossings_modulo_2(mesh, loops);
  return s;
}

namespace internal {

/// whether spins of neighbours, of the same sign, turn into each other by less than 120 degrees
bool is_clear(const Quaternion<double>& p, const Quaternion<double>& q)
{
  return dot(p, q) * dot(p, q) > 0.25 * squared_norm(p) * squared_norm(q);
}

/// whether spins of faces change their sign along a loop; false if thin faces or sudden turns leave
/// that open
bool changes_sign(const Mesh_view& mesh, const Mesh_view& deformed,
                  const Quaternion_vector<double>& spins, const Face_loop& loop)
{
  bool has_changed = false;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const int f = Mesh_view::face(loop[k]), g = Mesh_view::face(loop[(k + 1) % loop.size()]);
    if (is_thin(mesh, f) || is_thin(deformed, f) || !is_clear(spins[f], spins[g])) return false;
    has_changed ^= dot(spins[f], spins[g]) < 0;
  }
  return has_changed;
}

bool is_thin(const Mesh_view& mesh, int f)
{
  const Eigen::Matrix3d e = mesh.sheet(f).vectors;
  return !(mesh.double_area_vector(f).norm() > 1e-3 * e.colwise().squaredNorm().maxCoeff());
}

}  // namespace internal

void require_same_spin_structure(const Mesh_view& mesh, const Points& positions,
                                 const std::string& function)
{
  const Mesh_view deformed(positions, mesh.corners());
  const Quaternion_vector<double> spins = face_spins(mesh, positions);
  for (const internal::Face_loop& loop : loops_of_faces(mesh))
    if (internal::changes_sign(mesh, deformed, spins, loop))
      throw Precondition_error(
          function, "the surfaces are of different spin structure: around the loop of " +
                        std::to_string(loop.size()) + " faces that begins with face " +
                        std::to_string(Mesh_view::face(loop[0])) +
                        " one turns evenly and the other oddly; no deformation without creases "
                        "leads from one to the other");
}

int internal::Spin_structure::arf_invariant() const
{
  // Combines the loops to consecutive pairs that cross each other and no other loops: the invariant
  // is the sum of the products of their values. The value of a sum of two loops is the sum of their
  // values plus the number of their crossings.
  std::vector<int> q = values;
  Eigen::MatrixXi M = crossings;
  const Eigen::Index n = M.rows();
  const auto value = [&](Eigen::Index i) -> int& { return q[static_cast<std::size_t>(i)]; };
  std::vector<char> is_done(values.size(), 0);
  int arf = 0;
  for (Eigen::Index a = 0; a < n; ++a) {
    if (is_done[static_cast<std::size_t>(a)]) continue;
    Eigen::Index b = a + 1;
    while (b < n && (is_done[static_cast<std::size_t>(b)] || M(a, b) == 0)) ++b;
    if (b == n) continue;
    is_done[static_cast<std::size_t>(a)] = is_done[static_cast<std::size_t>(b)] = 1;
    arf ^= value(a) & value(b);
    const Eigen::VectorXi with_a = M.col(a), with_b = M.col(b);
    for (Eigen::Index c = 0; c < n; ++c) {
      if (is_done[static_cast<std::size_t>(c)]) continue;
      value(c) ^= (with_b[c] & value(a)) ^ (with_a[c] & value(b)) ^ (with_a[c] & with_b[c]);
      for (Eigen::Index d = 0; d < n; ++d)
        M(c, d) ^= (with_a[c] & with_b[d]) ^ (with_b[c] & with_a[d]);
    }
  }
  return arf;
}

Quaternion_vector<double> face_spins(const Mesh_view& mesh, const Points& positions)
{
  // Frame with T along the first edge of the face and N its normal; and coordinates of the third
  // corner.
  const auto frame = [](const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
    Eigen::Matrix3d F;
    F.col(0) = first.normalized();
    F.col(2) = first.cross(second).normalized();
    F.col(1) = F.col(2).cross(F.col(0));
    return F;
  };
  Quaternion_vector<double> q(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const Eigen::Vector3d x = mesh.position(v[1]) - mesh.position(v[0]),
                          y = mesh.position(v[2]) - mesh.position(v[0]),
                          X = positions.col(v[1]) - positions.col(v[0]),
                          Y = positions.col(v[2]) - positions.col(v[0]);
    const Eigen::Matrix3d from = frame(x, y), to = frame(X, Y);
    // In these frames the linear map is [a c; 0 d].
    const double a = X.norm() / x.norm();
    const double d = to.col(1).dot(Y) / from.col(1).dot(y);
    const double c = (to.col(0).dot(Y) - a * from.col(0).dot(y)) / from.col(1).dot(y);
    const Eigen::AngleAxisd nearest(std::atan2(-c, a + d), Eigen::Vector3d::UnitZ());
    q[f] = spin_of(Eigen::Matrix3d(to * nearest * from.transpose()), std::sqrt(a * d));
  }
  return q;
}

void replace_thin_faces(const Mesh_view& mesh, const Points& positions,
                        Quaternion_vector<double>& spins)
{
  const Mesh_view moved(positions, mesh.corners());
  std::vector<int> thin;
  std::vector<char> is_known(static_cast<std::size_t>(mesh.size_of_faces()), 1);
  const auto known = [&](int f) -> char& { return is_known[static_cast<std::size_t>(f)]; };
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    if (internal::is_thin(mesh, f) || internal::is_thin(moved, f)) thin.push_back(f), known(f) = 0;
  for (bool has_changed = true; has_changed;) {
    std::vector<int> rest, done;
    for (const int f : thin) {
      Quaternion<double> sum;
      int count = 0;
      for (int h = 3 * f; h < 3 * f + 3; ++h)
        if (const int t = mesh.twin(h); t >= 0 && known(Mesh_view::face(t))) {
          const Quaternion<double> q = spins[Mesh_view::face(t)];
          sum += dot(sum, q) < 0 ? q * -1. : q;
          ++count;
        }
      (count > 0 ? done : rest).push_back(f);
      if (count > 0) spins[f] = sum / count;
    }
    for (const int f : done) known(f) = 1;
    has_changed = !done.empty();
    thin = std::move(rest);
  }
}

int make_consistent(const Mesh_view& mesh, Quaternion_vector<double>& spins)
{
  std::vector<char> is_met(static_cast<std::size_t>(mesh.size_of_faces()), 0);
  std::vector<int> queue = {0};
  is_met[0] = 1;
  const auto for_each_neighbour = [&](int f, auto visit) {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      if (mesh.twin(h) >= 0) visit(Mesh_view::face(mesh.twin(h)));
  };
  for (std::size_t i = 0; i < queue.size(); ++i)
    for_each_neighbour(queue[i], [&, f = queue[i]](int g) {
      if (is_met[static_cast<std::size_t>(g)]) return;
      is_met[static_cast<std::size_t>(g)] = 1;
      if (dot(spins[f], spins[g]) < 0) spins[g] *= -1;
      queue.push_back(g);
    });
  int conflicts = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for_each_neighbour(f, [&](int g) { conflicts += f < g && dot(spins[f], spins[g]) < 0; });
  return conflicts;
}

Quaternion_vector<double> vertex_spins(const Mesh_view& mesh,
                                       const Quaternion_vector<double>& face_spins)
{
  const Eigen::VectorXd areas = curvature_areas(mesh, Curvature_potential::On::faces);
  Eigen::VectorXd vertex_area = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) vertex_area[v] += areas[f] / 3;
  Quaternion_vector<double> mu = Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {});
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) mu[v] += face_spins[f] * (areas[f] / 3 / vertex_area[v]);
  return mu;
}

namespace internal {

std::pair<Mesh_view, Points> in_frame(const Mesh_view& mesh, const Points& target)
{
  const Normalized_frame frame(mesh.positions());
  std::pair<Mesh_view, Points> both{mesh, frame.to_frame(target)};
  both.first.set_positions(frame.to_frame(mesh.positions()));
  return both;
}

Points checked_target(const Mesh_view& mesh, Points target,
                      const std::optional<double>& mollification, const std::string& function)
{
  Framed_surface::require(mesh, mollification, function);
  if (target.cols() != mesh.size_of_vertices())
    throw Precondition_error(function, std::to_string(target.cols()) +
                                           " target positions, one per vertex is needed: " +
                                           std::to_string(mesh.size_of_vertices()));
  Framed_surface::require_faces(Mesh_view(target, mesh.corners()), mollification.has_value(),
                                function + ", target");
  const auto [before, after] = in_frame(mesh, target);
  if (boundary_loops(mesh).empty() && !mollification)
    require_same_spin_structure(before, after, function);
  return target;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing
