// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>

#include <boost/property_map/property_map.hpp>

#include <memory>
#include <stdexcept>
#include <unordered_map>

#include "parameterization/Cut_surface.h"
#include "parameterization/cgal_method.h"

namespace cgp_benchmark {
namespace {

using Cones = std::unordered_map<Seam_vertex, SMP::Cone_type>;

/// Writes the point of a vertex of the seam mesh to the vertex of the disk
struct Disk_uv_map {
  UV_map uv;
  const std::unordered_map<Seam_vertex, int>* numbers;

  friend void put(const Disk_uv_map& map, Seam_vertex v, const Kernel::Point_2& point)
  {
    map.uv[Surface::Vertex_index(static_cast<Surface::size_type>(map.numbers->at(v)))] = point;
  }
};

Method orbifold_method(const std::string& name, Cut_surface& cut,
                       const std::shared_ptr<const Cones>& cones, SMP::Orbifold_type type,
                       SMP::Weight_type weights)
{
  return {"orbifold Tutte, " + name, [&cut, cones, type, weights](Surface&, Border, UV_map uv) {
            const SMP::Orbifold_Tutte_parameterizer_3<Seam> parameterizer(type, weights);
            return in_words(
                parameterizer.parameterize(cut.seam, {}, *cones, Disk_uv_map{uv, &cut.numbers},
                                           boost::make_assoc_property_map(cut.numbers)));
          }};
}

}  // namespace

std::vector<Method> orbifold_methods(Cut_surface& cut)
{
  const auto cones = std::make_shared<Cones>();
  if (!SMP::locate_cones(cut.seam, cut.cones.begin(), cut.cones.end(), *cones))
    throw std::runtime_error("the cones are not on the seam");
  std::vector<Method> methods;
  const auto add = [&](const std::string& name, SMP::Orbifold_type type) {
    methods.push_back(orbifold_method(name, cut, cones, type, SMP::Cotangent));
    methods.push_back(orbifold_method(name + ", mean value", cut, cones, type, SMP::Mean_value));
  };
  if (cut.cones.size() == 3) {
    add("square", SMP::Square);
    add("diamond", SMP::Diamond);
    add("triangle", SMP::Triangle);
  } else {
    add("parallelogram", SMP::Parallelogram);
  }
  return methods;
}

}  // namespace cgp_benchmark
