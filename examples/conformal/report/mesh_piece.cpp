// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "mesh_piece.h"

#include "conformal/process/at.h"

#include <numeric>
#include <utility>

namespace conformal {
namespace {

/// Which corners of faces are at the same vertex: those joined across an edge.
class Joined_corners {
 public:
  explicit Joined_corners(std::size_t count) : m_root(count)
  {
    std::iota(m_root.begin(), m_root.end(), 0);
  }

  void join(int a, int b) { m_root[at(root(a))] = root(b); }

  int root(int c)
  {
    while (m_root[at(c)] != c) c = m_root[at(c)] = m_root[at(m_root[at(c)])];
    return c;
  }

 private:
  std::vector<int> m_root;
};

Joined_corners joined_corners(const CGP::Mesh_view& mesh, const std::vector<int>& faces,
                              const std::vector<int>& region)
{
  using View = CGP::Mesh_view;
  std::vector<int> local(region.size(), -1);
  for (std::size_t k = 0; k < faces.size(); ++k) local[at(faces[k])] = static_cast<int>(k);
  Joined_corners joined(3 * faces.size());
  const auto corner = [&](int h) { return 3 * local[at(View::face(h))] + h % 3; };
  for (const int f : faces)
    for (int h = 3 * f; h < 3 * f + 3; ++h) {
      const int t = mesh.twin(h);
      if (t < 0 || region[at(View::face(t))] != region[at(f)]) continue;
      // One end of the edge; the other one is joined when t has its turn.
      joined.join(corner(View::next_in_face(h)), corner(View::previous_in_face(t)));
    }
  return joined;
}

}  // namespace

Mesh_piece mesh_piece(const CGP::Mesh_view& mesh, std::vector<int> faces,
                      const std::vector<int>& region)
{
  Joined_corners joined = joined_corners(mesh, faces, region);
  std::vector<int> number(3 * faces.size(), -1), vertices;
  CGP::Mesh_view::Corners corners(faces.size());
  for (std::size_t k = 0; k < faces.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      int& n = number[at(joined.root(static_cast<int>(3 * k + i)))];
      if (n < 0) {
        n = static_cast<int>(vertices.size());
        vertices.push_back(mesh.corners(faces[k])[i]);
      }
      corners[k][i] = n;
    }
  CGP::Points positions = mesh.positions()(Eigen::indexing::all, vertices);
  return {std::move(faces), CGP::Mesh_view(std::move(positions), std::move(corners))};
}

}  // namespace conformal
