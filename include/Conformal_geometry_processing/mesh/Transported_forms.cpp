// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Transported_forms.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

internal::Transported_forms::Transported_forms(const Mesh_view& mesh, const Eigen::MatrixXd& forms)
    : m_values(mesh.size_of_halfedges(), forms.cols()), m_sides(4, forms.cols())
{
  for (int h = 0; forms.cols() > 0 && h < mesh.size_of_halfedges(); ++h)
    m_values.row(h) = (mesh.from(h) < mesh.to(h) ? 1 : -1) * forms.row(mesh.edge(h));
}

void internal::Transported_forms::before_flip(const internal::Intrinsic_triangulation& triangles,
                                              int h)
{
  if (size() == 0) return;
  const int t = triangles.twin(h), a = 3 * (h / 3), b = 3 * (t / 3);
  m_sides << along(Mesh_view::next_in_face(h)), along(Mesh_view::previous_in_face(h)),
      along(Mesh_view::next_in_face(t)), along(Mesh_view::previous_in_face(t));
  const auto jk = m_sides.row(0), ki = m_sides.row(1), il = m_sides.row(2), lj = m_sides.row(3);
  // the new faces (k, i, l) and (l, j, k)
  m_values.row(a) = il;
  m_values.row(a + 1) = -(ki + il);
  m_values.row(a + 2) = ki;
  m_values.row(b) = jk;
  m_values.row(b + 1) = ki + il;
  m_values.row(b + 2) = lj;
}

}  // namespace Conformal_geometry_processing
