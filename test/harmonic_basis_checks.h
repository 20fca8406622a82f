// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/harmonic_basis.h>

#include <gtest/gtest.h>

#include <boost/concept_check.hpp>
#include <boost/property_map/property_map.hpp>

#include "support/cgal_meshes.h"
#include "support/handlebodies.h"
#include "support/meshes.h"

/// What harmonic_basis() finds on a mesh of any type, measured against the class on flat arrays.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

template <class Mesh>
Eigen::Vector3d coordinates(const Mesh& mesh,
                            typename boost::graph_traits<Mesh>::vertex_descriptor v)
{
  const auto& p = get(CGAL::get_const_property_map(CGAL::vertex_point, mesh), v);
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

template <class Vector>
Eigen::Vector3d to_eigen(const Vector& v)
{
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

/// closed, alternating, fitted by the fields, orthonormal
/// \param holes the number of loops of the boundary but the first
template <class Mesh>
void expect_harmonic_forms(const Mesh& mesh, int genus, int holes = 0)
{
  const auto forms = CGP::harmonic_basis(mesh);
  ASSERT_EQ(forms.genus(), genus);
  ASSERT_EQ(forms.size(), 2 * genus + holes);
  BOOST_CONCEPT_ASSERT(
      (boost::ReadablePropertyMapConcept<decltype(forms.one_form(0)),
                                         typename boost::graph_traits<Mesh>::halfedge_descriptor>));
  BOOST_CONCEPT_ASSERT(
      (boost::ReadablePropertyMapConcept<decltype(forms.tangent_field(0)),
                                         typename boost::graph_traits<Mesh>::face_descriptor>));
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(forms.size(), forms.size());
  for (const auto f : faces(mesh)) {
    Eigen::MatrixX3d v(forms.size(), 3);
    const auto h = halfedge(f, mesh);
    const Eigen::Vector3d a =
        coordinates(mesh, target(h, mesh)) - coordinates(mesh, source(h, mesh));
    const Eigen::Vector3d b =
        coordinates(mesh, target(next(h, mesh), mesh)) - coordinates(mesh, target(h, mesh));
    for (int i = 0; i < forms.size(); ++i) {
      const auto form = forms.one_form(i);
      const double sum =
          get(form, h) + get(form, next(h, mesh)) + get(form, next(next(h, mesh), mesh));
      EXPECT_NEAR(sum, 0, 1e-14);
      EXPECT_EQ(get(form, h), -get(form, opposite(h, mesh)));
      const Eigen::Vector3d field = to_eigen(get(forms.tangent_field(i), f));
      EXPECT_NEAR(field.dot(a), get(form, h), 1e-13);
      EXPECT_NEAR(field.dot(b), get(form, next(h, mesh)), 1e-13);
      EXPECT_NEAR(field.dot(a.cross(b)), 0, 1e-13);
      v.row(i) = field.transpose();
    }
    gram += a.cross(b).norm() / 2 * v * v.transpose();
  }
  const auto n = gram.rows();
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(n, n)).norm(), 1e-12);
}

/// the same numbers as the class gives for the view of the mesh
template <class Mesh>
void expect_basis_of_the_view(const Mesh& mesh)
{
  const CGP::Graph_view<Mesh> graph(mesh, CGP::parameters::default_values(), "test");
  const Mesh_view& view = graph.view();
  const CGP::Harmonic_basis expected = CGP::Hodge_decomposition(view).harmonic_basis();
  const auto forms = CGP::harmonic_basis(mesh);
  ASSERT_EQ(forms.size(), expected.size());
  for (int i = 0; i < forms.size(); ++i)
    for (int f = 0; f < view.size_of_faces(); ++f) {
      const Eigen::Vector3d v = to_eigen(get(forms.tangent_field(i), graph.face(f)));
      EXPECT_LT((v - expected.fields[at(i)].col(f)).norm(), 1e-12);
      EXPECT_NEAR(get(forms.one_form(i), halfedge(graph.face(f), mesh)),
                  CGP::along_halfedge(view, expected.one_forms.col(i), 3 * f + 2), 1e-13);
    }
}

}  // namespace cgp_test
