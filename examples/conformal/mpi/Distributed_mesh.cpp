// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Distributed_mesh.h"

#include "conformal/process/Failure.h"

#include <Quaternionic_linear_algebra/adapters/Petsc_matrix.h>

#include <petscmat.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace conformal::mpi {
namespace {

using CGP::internal::check_petsc;
using Partitioning = CGP::internal::Petsc_handle<MatPartitioning, MatPartitioningDestroy>;
using Index_set = CGP::internal::Petsc_handle<IS, ISDestroy>;

std::size_t at(int i)
{
  return static_cast<std::size_t>(i);
}

void sort_and_make_unique(std::vector<int>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// the neighbours of the vertices of a range
std::vector<std::vector<int>> neighbours(const std::vector<std::array<int, 3>>& corners,
                                         const Ranges& ranges)
{
  std::vector<std::vector<std::array<int, 2>>> to(at(processes()));
  for (const std::array<int, 3>& v : corners)
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = v[c], b = v[(c + 1) % 3];
      to[ranges.owner(a)].push_back({a, b});
      to[ranges.owner(b)].push_back({b, a});
    }
  std::vector<std::vector<int>> found(at(ranges.size()));
  for (const auto& [a, b] : deliver(to))
    if (a != b) found[at(a - ranges.begin())].push_back(b);
  for (std::vector<int>& of_vertex : found) sort_and_make_unique(of_vertex);
  return found;
}

/// \brief the graph, whose arrays PETSc frees, as a matrix
CGP::internal::Petsc_mat adjacency(const std::vector<std::vector<int>>& graph, int vertices)
{
  std::size_t entries = 0;
  for (const std::vector<int>& row : graph) entries += row.size();
  PetscInt *first = nullptr, *columns = nullptr;
  check_petsc(PetscMalloc1(graph.size() + 1, &first));
  check_petsc(PetscMalloc1(entries + 1, &columns));
  first[0] = 0;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    std::copy(graph[v].begin(), graph[v].end(), columns + first[v]);
    first[v + 1] = first[v] + static_cast<PetscInt>(graph[v].size());
  }
  CGP::internal::Petsc_mat matrix;
  check_petsc(MatCreateMPIAdj(PETSC_COMM_WORLD, static_cast<PetscInt>(graph.size()), vertices,
                              first, columns, nullptr, matrix.renew()));
  return matrix;
}

}  // namespace

Distributed_mesh::Distributed_mesh(const Ply_ranges& file, bool has_loops)
{
  const Ranges in_file = Ranges::equal(file.vertices()), faces = Ranges::equal(file.faces());
  std::vector<std::array<int, 3>> corners;
  together([&] {
    if (file.vertices() < 4 * processes())
      throw Failure(Exit_code::unsuitable, "there are too few vertices for so many processes");
    corners = file.corners(faces.begin(), faces.end());
  });
  take_vertices(file, in_file, divide(corners, in_file));
  take_faces(corners, in_file);
  together([&] { require_stars(); });
  require_connected();
  find_topology(has_loops);
}

std::vector<int> Distributed_mesh::divide(const std::vector<std::array<int, 3>>& corners,
                                          const Ranges& in_file) const
{
  if (processes() == 1) return std::vector<int>(at(in_file.size()), 0);
  const CGP::internal::Petsc_mat graph = adjacency(neighbours(corners, in_file), in_file.total());
  Partitioning partitioning;
  Index_set parts;
  check_petsc(MatPartitioningCreate(PETSC_COMM_WORLD, partitioning.renew()));
  check_petsc(MatPartitioningSetAdjacency(partitioning.get(), graph.get()));
  check_petsc(MatPartitioningSetType(partitioning.get(), MATPARTITIONINGPTSCOTCH));
  check_petsc(MatPartitioningSetFromOptions(partitioning.get()));
  check_petsc(MatPartitioningApply(partitioning.get(), parts.renew()));
  const PetscInt* part = nullptr;
  check_petsc(ISGetIndices(parts.get(), &part));
  const std::vector<int> found(part, part + in_file.size());
  check_petsc(ISRestoreIndices(parts.get(), &part));
  return found;
}

void Distributed_mesh::take_vertices(const Ply_ranges& file, const Ranges& in_file,
                                     const std::vector<int>& parts)
{
  struct Vertex {
    int number;
    double x, y, z;
  };
  CGP::Points p;
  together([&] { p = file.positions(in_file.begin(), in_file.end()); });
  std::vector<std::vector<Vertex>> to(at(processes()));
  for (int k = 0; k < in_file.size(); ++k)
    to[at(parts[at(k)])].push_back({in_file.begin() + k, p(0, k), p(1, k), p(2, k)});
  const std::vector<Vertex> own = deliver(to);  // in the order of the file
  together([&] {
    if (own.empty()) throw Failure(Exit_code::failed, "a process has got no vertices; try: fewer");
  });
  m_ranges = Ranges::of(static_cast<int>(own.size()));
  m_own_positions.resize(3, static_cast<Eigen::Index>(own.size()));
  std::vector<std::vector<std::array<int, 2>>> names(at(processes()));
  for (std::size_t k = 0; k < own.size(); ++k) {
    m_number_in_file.push_back(own[k].number);
    m_own_positions.col(static_cast<Eigen::Index>(k)) =
        Eigen::Vector3d(own[k].x, own[k].y, own[k].z);
    names[in_file.owner(own[k].number)].push_back(
        {own[k].number, m_ranges.begin() + static_cast<int>(k)});
  }
  m_new_numbers.resize(at(in_file.size()));
  for (const auto& [old, now] : deliver(names)) m_new_numbers[at(old - in_file.begin())] = now;
}

void Distributed_mesh::take_faces(const std::vector<std::array<int, 3>>& corners,
                                  const Ranges& in_file)
{
  std::vector<int> flat;
  for (const std::array<int, 3>& v : corners) flat.insert(flat.end(), v.begin(), v.end());
  flat = look_up(flat, in_file, m_new_numbers);
  std::vector<std::vector<std::array<int, 3>>> to(at(processes()));
  for (std::size_t f = 0; f < corners.size(); ++f) {
    const std::array<int, 3> v{flat[3 * f], flat[3 * f + 1], flat[3 * f + 2]};
    std::vector<int> owners;
    for (const int i : v) owners.push_back(static_cast<int>(m_ranges.owner(i)));
    sort_and_make_unique(owners);
    for (const int p : owners) to[at(p)].push_back(v);
  }
  std::vector<std::array<int, 3>> faces = deliver(to);
  const auto is_counted = [&](const std::array<int, 3>& v) {
    return m_ranges.is_mine(*std::min_element(v.begin(), v.end()));
  };
  m_own_faces = static_cast<int>(std::stable_partition(faces.begin(), faces.end(), is_counted) -
                                 faces.begin());
  for (const std::array<int, 3>& v : faces)
    for (const int i : v)
      if (!m_ranges.is_mine(i)) m_others.push_back(i);
  sort_and_make_unique(m_others);
  for (std::array<int, 3>& v : faces)
    for (int& i : v)
      i = m_ranges.is_mine(i)
              ? i - m_ranges.begin()
              : own_vertices() +
                    static_cast<int>(std::lower_bound(m_others.begin(), m_others.end(), i) -
                                     m_others.begin());
  std::vector<std::vector<int>> needed(at(processes()));
  for (const int i : m_others) needed[m_ranges.owner(i)].push_back(i);
  std::vector<int> counts;
  const std::vector<int> asked = deliver(needed, &counts);
  for (std::size_t p = 0, next = 0; p < needed.size(); ++p) {
    m_sent.emplace_back();
    for (int k = 0; k < counts[p]; ++k) m_sent[p].push_back(asked[next++] - m_ranges.begin());
  }
  Eigen::MatrixXd all(3, own_vertices() + static_cast<int>(m_others.size()));
  all.leftCols(own_vertices()) = m_own_positions;
  m_own_positions.resize(3, 0);
  update(all);
  m_mesh = CGP::Mesh_view(all, std::move(faces));
}

void Distributed_mesh::update(Eigen::MatrixXd& values) const
{
  std::vector<std::vector<double>> to(m_sent.size());
  for (std::size_t p = 0; p < m_sent.size(); ++p)
    for (const int v : m_sent[p])
      to[p].insert(to[p].end(), values.col(v).data(), values.col(v).data() + values.rows());
  const std::vector<double> got = deliver(to);
  values.rightCols(static_cast<Eigen::Index>(m_others.size())) = Eigen::Map<const Eigen::MatrixXd>(
      got.data(), values.rows(), static_cast<Eigen::Index>(m_others.size()));
}

Eigen::MatrixXd Distributed_mesh::in_order_of_file(const Eigen::MatrixXd& own) const
{
  const Ranges in_file = Ranges::equal(m_ranges.total());
  std::vector<std::vector<int>> names(m_sent.size());
  std::vector<std::vector<double>> columns(m_sent.size());
  for (Eigen::Index v = 0; v < own.cols(); ++v) {
    const int name = m_number_in_file[static_cast<std::size_t>(v)];
    const std::size_t p = in_file.owner(name);
    names[p].push_back(name);
    columns[p].insert(columns[p].end(), own.col(v).data(), own.col(v).data() + own.rows());
  }
  const std::vector<int> got_names = deliver(names);
  const std::vector<double> got = deliver(columns);
  Eigen::MatrixXd ordered(own.rows(), in_file.size());
  for (std::size_t k = 0; k < got_names.size(); ++k)
    ordered.col(got_names[k] - in_file.begin()) = Eigen::Map<const Eigen::VectorXd>(
        got.data() + static_cast<Eigen::Index>(k) * own.rows(), own.rows());
  return ordered;
}

Eigen::MatrixXd Distributed_mesh::from_order_of_file(const Eigen::MatrixXd& ordered) const
{
  const Ranges in_file = Ranges::equal(m_ranges.total());
  Eigen::MatrixXd own(ordered.rows(), own_vertices());
  for (Eigen::Index r = 0; r < own.rows(); ++r) {
    const Eigen::VectorXd row = ordered.row(r);
    const std::vector<double> values = look_up(
        m_number_in_file, in_file, std::vector<double>(row.data(), row.data() + row.size()));
    own.row(r) = Eigen::Map<const Eigen::RowVectorXd>(values.data(), own.cols());
  }
  return own;
}

CGP::internal::Surface_part Distributed_mesh::part() const
{
  return {own_vertices(),
          m_own_faces,
          [this](int edge) { return counts(edge); },
          [](const Eigen::VectorXd& own) { return sum_of(own); },
          [](double own) { return largest(own); },
          [this](Eigen::MatrixXd& all) { update(all); }};
}

// All faces around an own vertex are in the part: a fan from one boundary to the other, or a wheel.
void Distributed_mesh::require_stars() const
{
  const auto name = [&](int v) { return "vertex " + std::to_string(m_number_in_file[at(v)]); };
  std::vector<int> faces(at(own_vertices()), 0), begin(at(own_vertices()), -1);
  for (int h = 0; h < m_mesh.size_of_halfedges(); ++h) {
    const int i = m_mesh.from(h), j = m_mesh.to(h);
    if (i >= own_vertices() && j >= own_vertices()) continue;
    const int own = (std::min)(i, j);
    if (i == j) throw Failure(Exit_code::unsuitable, "a face has two corners at " + name(own));
    const int k = m_mesh.edge(h);
    const auto sides = m_mesh.halfedges_end(k) - m_mesh.halfedges_begin(k);
    if (sides > 2 || (sides == 2 && m_mesh.twin(h) < 0))
      throw Failure(Exit_code::unsuitable,
                    "an edge at " + name(own) + " has not two faces that are oriented alike");
    if (i >= own_vertices()) continue;
    ++faces[at(i)];
    if (sides == 1 || begin[at(i)] < 0) begin[at(i)] = h;
  }
  for (int v = 0; v < own_vertices(); ++v) {
    if (faces[at(v)] == 0) throw Failure(Exit_code::unsuitable, name(v) + " has no face");
    int around = 0, h = begin[at(v)];
    do {  // to the next halfedge from v
      h = m_mesh.twin(CGP::Mesh_view::previous_in_face(h));
    } while (++around <= faces[at(v)] && h >= 0 && h != begin[at(v)]);
    if (around != faces[at(v)])
      throw Failure(Exit_code::unsuitable, "the surface touches itself at " + name(v));
  }
}

// V - E + F is 2 - 2 g - b with g handles and b boundaries.
void Distributed_mesh::find_topology(bool may_have_loops)
{
  Eigen::Vector2d edges(0, 0);
  for (int k = 0; k < m_mesh.size_of_edges(); ++k)
    if (counts(k))
      edges += Eigen::Vector2d(1, m_mesh.halfedges_end(k) - m_mesh.halfedges_begin(k) == 1);
  edges = sum_of(edges);
  m_is_closed = edges[1] == 0;
  const double characteristic = m_ranges.total() - edges[0] + sum(static_cast<double>(m_own_faces));
  if (!may_have_loops && characteristic != (m_is_closed ? 2 : 1))
    throw Failure(Exit_code::unsuitable,
                  "the surface has handles or holes, which only conformal spin keeps closed; try: "
                  "--open-handles");
}

// The least number of a component spreads in each part at once, and then between parts.
void Distributed_mesh::require_connected() const
{
  const int n = m_mesh.size_of_vertices();
  std::vector<int> root(at(n));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[at(v)] != v) v = root[at(v)] = root[at(root[at(v)])];
    return v;
  };
  for (int k = 0; k < m_mesh.size_of_edges(); ++k)
    root[at(find(m_mesh.ends(k)[0]))] = find(m_mesh.ends(k)[1]);
  Eigen::MatrixXd least(1, n);
  for (int v = 0; v < n; ++v) least(0, v) = number(v);
  for (bool has_changed = true; has_changed;) {
    Eigen::MatrixXd next = least;
    for (int v = 0; v < n; ++v) next(0, find(v)) = (std::min)(next(0, find(v)), least(0, v));
    for (int v = 0; v < n; ++v) next(0, v) = next(0, find(v));
    update(next);
    has_changed = largest(next == least ? 0 : 1) > 0;
    least = next;
  }
  if (largest(least.maxCoeff()) > 0)
    throw Failure(Exit_code::unsuitable,
                  "the surface has several components; try: conformal split");
}

}  // namespace conformal::mpi
