// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/spin_structure.h>

#include <Conformal_geometry_processing/algebra/rotor.h>
#include <Conformal_geometry_processing/spin/face_spins.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <vector>

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

}  // namespace Conformal_geometry_processing
