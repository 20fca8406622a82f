// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/Spectral_conformal_parameterizer_3.h>
#include <Conformal_geometry_processing/conformal_parameterization.h>

#include "parameterization/cgal_method.h"

namespace cgp_benchmark {
namespace {

namespace CGP = Conformal_geometry_processing;

Method ours(const std::string& name, CGP::Parameterization_options::Normals normals)
{
  return {name, [normals](Surface& mesh, Border, UV_map uv) -> std::string {
            const CGP::Graph_view<Surface> graph(mesh, CGP::parameters::default_values(), "ours");
            CGP::Parameterization_options options;
            options.normals = normals;
            const auto result = CGP::spectral_parameterization(graph.view(), options);
            CGP::internal::write_plane_points(graph, result.z, uv);
            return result.report ? "OK" : "not converged";
          }};
}

}  // namespace

std::vector<Method> our_methods()
{
  return {
      ours("spectral", CGP::Parameterization_options::Normals::of_faces),
      cgal_method("spectral, as a Parameterizer_3",
                  CGP::Spectral_conformal_parameterizer_3<Surface>()),
      ours("spectral, normals of vertices", CGP::Parameterization_options::Normals::of_vertices)};
}

}  // namespace cgp_benchmark
