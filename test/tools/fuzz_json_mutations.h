// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/file/base64.h"
#include "fuzz_readers_mutations.h"
#include "fuzz_readers_seeds.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Damages what a JSON document says, not how it is written: values that are missing, of another
// kind, of another place, or too many. Bytes at random hardly ever get beyond the parser.

namespace fuzz {

using Json = nlohmann::json;

/// a value inside of a document that is not a scalar, at any depth: its parent and key
inline Json& random_container(Json& document, Mutator& mutator)
{
  Json* at = &document;
  for (std::size_t depth = mutator.below(8); depth > 0; --depth) {
    std::vector<Json*> inner;
    for (Json& value : *at)
      if (value.is_structured() && !value.empty()) inner.push_back(&value);
    if (inner.empty()) break;
    at = inner[mutator.below(inner.size())];
  }
  return *at;
}

inline Json::iterator random_value(Json& container, Mutator& mutator)
{
  auto at = container.begin();
  for (std::size_t i = mutator.below(container.size()); i > 0; --i) ++at;
  return at;
}

inline Json odd_value(Mutator& mutator)
{
  const std::vector<Json> values = {nullptr,       true,           0,           -1,        1.5,
                                    1e300,         4294967295u,    2147483648u, "",        "a",
                                    Json::array(), Json::object(), {0, 0, 0},   {{"a", 1}}};
  return values[mutator.below(values.size())];
}

inline void mutate(Json& document, Mutator& mutator)
{
  Json& container = random_container(document, mutator);
  if (!container.is_structured() || container.empty()) return;
  const auto at = random_value(container, mutator);
  switch (mutator.below(4)) {
    case 0:
      container.erase(at);
      break;
    case 1:
      *at = odd_value(mutator);
      break;
    case 2:
      *at = Json(*random_value(random_container(document, mutator), mutator));
      break;
    default:
      if (container.is_array()) container.push_back(Json(*at));
      break;
  }
}

/// a JSON document with a few faults
inline std::string mutant_of_json(const std::string& text, Mutator& mutator)
{
  Json document = Json::parse(text);
  for (std::size_t faults = 1 + mutator.below(3); faults > 0 && !document.empty(); --faults)
    mutate(document, mutator);
  return document.dump();
}

/// the JSON and the bytes of a GLB file
inline std::pair<std::string, std::string> chunks(const std::string& file)
{
  const std::size_t begin = 20, size = static_cast<unsigned char>(file[12]) +
                                       256u * static_cast<unsigned char>(file[13]);
  return {file.substr(begin, size), file.substr((std::min)(file.size(), begin + size + 8))};
}

/// a GLB file whose JSON has a few faults, and the lengths of its chunks none
inline std::string mutant_of_glb(const std::string& file, Mutator& mutator)
{
  const auto [json, bytes] = chunks(file);
  return glb(mutant_of_json(json, mutator), bytes);
}

/// the same as a glTF file, which has its bytes as text
inline std::string gltf_of(const std::string& file)
{
  const auto [json, bytes] = chunks(file);
  Json document = Json::parse(json);
  document["buffers"][0]["uri"] =
      "data:application/octet-stream;base64," + conformal::base64(bytes);
  return document.dump();
}

inline std::vector<std::string> gltf_seeds()
{
  std::vector<std::string> files = glb_seeds();
  for (std::string& file : files) file = gltf_of(file);
  return files;
}

}  // namespace fuzz
