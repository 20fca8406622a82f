// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "studio_page.h"

#include "conformal/report/page_blocks.h"

#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/version.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>

namespace conformal {
namespace {

std::string data_of(const Studio_shape& shape, std::size_t k)
{
  const std::string number = "-" + std::to_string(k);
  return numbers_block<double>("positions" + number, shape.mesh.positions().reshaped()) +
         faces_block("faces" + number, shape.mesh) +
         numbers_block<float>("squares" + number, squares_of(shape)) +
         numbers_block<std::uint32_t>("origin" + number, shape.vertex_in_file);
}

}  // namespace

std::string studio_page(const std::vector<Studio_shape>& shapes, const Studio_frame& frame)
{
  nlohmann::json list;
  std::string data;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const Studio_shape& shape = shapes[k];
    list.push_back({{"name", shape.name},
                    {"file", shape.file},
                    {"fileVertices", shape.file_vertices},
                    {"isRepaired", shape.is_repaired}});
    data += data_of(shape, k);
  }
  const nlohmann::json page = {{"version", CONFORMAL_GEOMETRY_PROCESSING_VERSION},
                               {"bound", CGP::internal::default_scale_bound},
                               {"shapes", list}};
  const auto replace = nlohmann::json::error_handler_t::replace;  // a path need not be UTF-8
  return frame.begin + json_block("studio", page.dump(-1, ' ', false, replace)) + data + frame.end;
}

}  // namespace conformal
