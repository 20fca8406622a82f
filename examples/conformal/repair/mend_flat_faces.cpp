// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "mend_flat_faces.h"

#include "Flatness.h"
#include "Triangle_soup.h"

#include <algorithm>
#include <numeric>

namespace conformal {
namespace {

class Mender {
 public:
  Mender(Triangle_soup& soup, Mended_faces& done) : m_soup(soup), m_rule(soup), m_done(done)
  {
    for (int t = 0; t < soup.size(); ++t) keep_if_flat(t);
  }

  bool finds_any() const { return !m_left.empty(); }

  // What changes more comes where what changes less has done all it can: a flip leaves all
  // vertices, a collapse the manifold.
  void mend()
  {
    remove_components_without_area();
    while (pass(&Mender::flip_or_remove) || pass(&Mender::collapse) || pass(&Mender::unite) ||
           pass(&Mender::remove_at_cut))
      continue;
    remove_components_without_area();
  }

 private:
  void keep_if_flat(int t)
  {
    if (m_soup[t].is_alive && m_rule.is_flat(t)) m_left.push_back(t);
  }

  bool pass(bool (Mender::*step)(int))
  {
    std::vector<int> flat = std::move(m_left);
    m_left.clear();
    bool has_changed = false;
    for (const int t : flat) {
      if (!m_soup[t].is_alive || !m_rule.is_flat(t)) continue;
      if ((this->*step)(t))
        has_changed = true;
      else
        m_left.push_back(t);
    }
    std::sort(m_left.begin(), m_left.end());
    m_left.erase(std::unique(m_left.begin(), m_left.end()), m_left.end());
    return has_changed;
  }

  void remove(int t)
  {
    m_done.removed.push_back({m_soup.vertex(t, 0), m_soup.vertex(t, 1), m_soup.vertex(t, 2)});
    m_soup.remove(t);
  }

  bool flip_or_remove(int t)
  {
    const std::array<int, 3> order = m_rule.longest_edge_first(t);
    if (m_soup.neighbor(t, order[0]) < 0) {
      remove(t);
      return true;
    }
    for (const int k : {order[0], order[1]}) {  // of a needle, two are the longest
      const int g = m_soup.neighbor(t, k);
      if (g < 0 || !m_rule.is_better_flipped(t, k, g)) continue;
      m_soup.flip(t, k, g);
      ++m_done.flipped_edges;
      keep_if_flat(t);
      keep_if_flat(g);
      return true;
    }
    return false;
  }

  bool collapse(int t)
  {
    double least = 0;
    int from = -1, to = -1;
    for (int k = 0; k < 3; ++k)
      for (const int step : {1, 2}) {
        const int v = m_soup.vertex(t, k), w = m_soup.vertex(t, k + step);
        const double cost = m_rule.cost_of_collapse(v, w);
        if (cost < 0 || (from >= 0 && cost >= least)) continue;
        least = cost;
        from = v;
        to = w;
      }
    if (from >= 0) collapse(from, to);
    return from >= 0;
  }

  void collapse(int from, int to)
  {
    m_soup.collapse(from, to);
    m_done.collapsed.emplace_back(from, to);
    m_done.longest_collapsed =
        std::max(m_done.longest_collapsed, m_rule.length(from, to) * m_rule.unit());
    for (const int s : m_soup.around(to)) keep_if_flat(s);
  }

  // Two points at almost the same place are merged like those at the same one.
  bool unite(int t)
  {
    const std::array<int, 3> order = m_rule.longest_edge_first(t);
    const int v = m_soup.vertex(t, order[2] + 1), w = m_soup.vertex(t, order[2] + 2);
    const double longest =
        m_rule.length(m_soup.vertex(t, order[0] + 1), m_soup.vertex(t, order[0] + 2));
    if (m_rule.is_better_united(v, w, longest))
      collapse(v, w);
    else if (m_rule.is_better_united(w, v, longest))
      collapse(w, v);
    else
      return false;
    return true;
  }

  // Where the surface ends or will be cut open, a slit more is better than no surface.
  bool remove_at_cut(int t)
  {
    for (int k = 0; k < 3; ++k)
      if (m_rule.is_at_boundary(m_soup.vertex(t, k))) {
        remove(t);
        return true;
      }
    return false;
  }

  void remove_components_without_area()
  {
    std::vector<char> is_known(static_cast<std::size_t>(m_soup.size()), 0);
    for (const int t : m_left) {
      const std::vector<int> component = flat_component(t, is_known);
      for (const int s : component) remove(s);
    }
    m_left.erase(
        std::remove_if(m_left.begin(), m_left.end(), [&](int t) { return !m_soup[t].is_alive; }),
        m_left.end());
  }

  // The triangles of a component, if it is not known yet and all of them are flat.
  std::vector<int> flat_component(int first, std::vector<char>& is_known) const
  {
    const auto visit = [&](int t) {
      char& known = is_known[static_cast<std::size_t>(t)];
      return known ? false : (known = 1) != 0;
    };
    if (!visit(first)) return {};
    std::vector<int> component = {first};
    bool has_area = false;
    for (std::size_t i = 0; i < component.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const int g = m_soup.neighbor(component[i], k);
        if (g < 0) continue;
        if (!m_rule.is_flat(g))
          has_area = true;
        else if (visit(g))
          component.push_back(g);
      }
    if (has_area) component.clear();
    return component;
  }

  Triangle_soup& m_soup;
  Flatness m_rule;
  Mended_faces& m_done;
  std::vector<int> m_left;  // flat ones
};

int size_of_polygons(const Polygons& polygons)
{
  int count = 0;
  for (std::size_t f = 0; f < polygons.size(); ++f) count += polygons.degree(f) > 3;
  return count;
}

}  // namespace

Mended_faces mend_flat_faces(Surface_file& file)
{
  Mended_faces done;
  Triangle_soup soup(file);
  Mender mender(soup, done);
  if (!mender.finds_any()) {
    done.face_in_file.resize(file.polygons.size());
    std::iota(done.face_in_file.begin(), done.face_in_file.end(), 0);
    return done;
  }
  const int polygons = size_of_polygons(file.polygons);
  mender.mend();
  Selected_faces faces = soup.faces();
  done.face_in_file = faces.face_in_file;
  select_faces(file, std::move(faces));
  done.cut_polygons = polygons - size_of_polygons(file.polygons);
  return done;
}

}  // namespace conformal
