// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "targets.h"

#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/read_bytes.h"
#include "conformal/process/Failure.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace conformal {
namespace {

using Json = nlohmann::json;

/// one entry of the list, and how to complain about it
class Entry {
 public:
  Entry(const Json& json, std::size_t number, const std::string& path)
      : m_json(json), m_name("target " + std::to_string(number)), m_path(path)
  {
    const std::set<std::string> known = {"vertex", "vertices", "box", "to", "move", "turn"};
    if (!json.is_object()) fail("is not an object {...}");
    for (const auto& item : json.items())
      if (known.count(item.key()) == 0) fail("has the unknown key \"" + item.key() + '"');
    if (has("vertex") + has("vertices") + has("box") != 1)
      fail("needs one of \"vertex\", \"vertices\", \"box\"");
    if (has("to") && (!has("vertex") || has("move")))
      fail("has \"to\", which is for a \"vertex\" without \"move\"");
    if (has("turn") && has("vertex")) fail("has \"turn\", which is for regions");
  }

  bool has(const char* key) const { return m_json.contains(key); }
  const Json& at(const char* key) const { return m_json[key]; }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw Read_error(m_path, 0, m_name + ' ' + what);
  }

  /// about the surface
  [[noreturn]] void refuse(const std::string& what) const
  {
    throw unsuitable(m_path, m_name + ' ' + what);
  }

  /// `count` finite numbers
  std::vector<double> numbers(const Json& json, std::size_t count, const std::string& key) const
  {
    const std::string wanted = '"' + key + "\" that is not " + std::to_string(count) + " numbers";
    if (!json.is_array() || json.size() != count) fail("has a " + wanted);
    std::vector<double> all;
    for (const Json& number : json) {
      if (!number.is_number() || !std::isfinite(number.get<double>())) fail("has a " + wanted);
      all.push_back(number.get<double>());
    }
    return all;
  }

  Eigen::Vector3d vector(const char* key) const { return vector(at(key), key); }

  Eigen::Vector3d vector(const Json& json, const std::string& key) const
  {
    const std::vector<double> n = numbers(json, 3, key);
    return {n[0], n[1], n[2]};
  }

 private:
  const Json& m_json;
  std::string m_name, m_path;
};

/// the vertices of the mesh by their numbers in the file as it was before it was repaired
class Numbering {
 public:
  explicit Numbering(const Surface_input& input)
      : m_repair(input.repair), m_vertex(input.file.points.size(), -1)
  {
    for (std::size_t v = 0; v < input.vertex_in_file.size(); ++v)
      m_vertex[static_cast<std::size_t>(input.vertex_in_file[v])] = static_cast<int>(v);
  }

  int vertex(const Json& number, const Entry& entry) const
  {
    if (!number.is_number_integer()) entry.fail("has a vertex that is not a whole number");
    const auto n = number.get<std::int64_t>();
    const std::size_t size = m_repair ? m_repair->new_vertex.size() : m_vertex.size();
    if (n < 0 || n >= static_cast<std::int64_t>(size))
      entry.refuse("is for vertex " + std::to_string(n) + ", but the surface has 0 to " +
                   std::to_string(size - 1));
    const int in_file =
        m_repair ? m_repair->new_vertex[static_cast<std::size_t>(n)] : static_cast<int>(n);
    const int v = in_file < 0 ? -1 : m_vertex[static_cast<std::size_t>(in_file)];
    if (v < 0) entry.refuse("is for vertex " + std::to_string(n) + ", which no face has");
    return v;
  }

 private:
  const std::optional<Repair>& m_repair;
  std::vector<int> m_vertex;
};

std::vector<int> vertices_in_box(const CGP::Mesh_view& mesh, const Entry& entry)
{
  const Json& box = entry.at("box");
  if (!box.is_array() || box.size() != 2) entry.fail("has a \"box\" that is not two corners");
  const Eigen::Vector3d a = entry.vector(box[0], "box"), b = entry.vector(box[1], "box");
  std::vector<int> inside;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    if ((p.array() >= a.cwiseMin(b).array()).all() && (p.array() <= a.cwiseMax(b).array()).all())
      inside.push_back(v);
  }
  if (inside.empty()) entry.refuse("has a box without any vertex of the surface");
  return inside;
}

std::vector<int> vertices_of(const CGP::Mesh_view& mesh, const Numbering& numbering,
                             const Entry& entry)
{
  if (entry.has("box")) return vertices_in_box(mesh, entry);
  if (entry.has("vertex")) return {numbering.vertex(entry.at("vertex"), entry)};
  const Json& list = entry.at("vertices");
  if (!list.is_array() || list.empty())
    entry.fail("has \"vertices\" that are not a list of numbers");
  std::set<int> all;
  for (const Json& number : list) all.insert(numbering.vertex(number, entry));
  return {all.begin(), all.end()};
}

Eigen::Matrix3d turn_of(const Entry& entry)
{
  const std::vector<double> n = entry.numbers(entry.at("turn"), 4, "turn");
  const Eigen::Vector3d axis(n[0], n[1], n[2]);
  if (!(axis.norm() > 0)) entry.fail("has a \"turn\" without an axis");
  const double degree = std::acos(-1.) / 180;
  return Eigen::AngleAxisd(n[3] * degree, axis.stableNormalized()).toRotationMatrix();
}

Target target_of(const CGP::Mesh_view& mesh, const Numbering& numbering, const Entry& entry)
{
  Target target;
  target.vertices = vertices_of(mesh, numbering, entry);
  target.is_region = !entry.has("vertex");
  if (entry.has("move")) target.move = entry.vector("move");
  if (entry.has("to")) target.move = entry.vector("to") - mesh.position(target.vertices[0]);
  if (entry.has("turn")) target.turn = turn_of(entry);
  return target;
}

Json parse(const std::string& path)
{
  const std::string text = read_bytes(path, "a file with targets");
  try {
    Json json = Json::parse(text);
    if (!json.is_object() || !json.contains("targets") || !json["targets"].is_array() ||
        json["targets"].empty())
      throw Read_error(path, 0,
                       "has no targets; wanted: {\"targets\": [{\"vertex\": 0, \"to\": "
                       "[0, 0, 0]}, ...]}");
    return json;
  } catch (const Json::parse_error& error) {
    const std::string_view before = std::string_view(text).substr(0, error.byte);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    throw Read_error(path, static_cast<std::size_t>(lines) + 1, "is not JSON");
  } catch (const Json::out_of_range&) {
    throw Read_error(path, 0, "has a number that is out of range");
  }
}

/// of a region: the vertices that are in the surface
std::vector<int> kept(const std::vector<int>& vertices, const std::vector<int>& number)
{
  std::vector<int> own;
  for (const int v : vertices)
    if (number[static_cast<std::size_t>(v)] >= 0)
      own.push_back(number[static_cast<std::size_t>(v)]);
  return own;
}

}  // namespace

std::vector<Target> read_targets(const Surface_input& input, const std::string& path)
{
  const Json json = parse(path);
  const Numbering numbering(input);
  std::vector<Target> targets;
  std::vector<int> first(static_cast<std::size_t>(input.mesh.size_of_vertices()), -1);
  for (const Json& json_of_one : json["targets"]) {
    const std::size_t number = targets.size();
    const Entry entry(json_of_one, number, path);
    targets.push_back(target_of(input.mesh, numbering, entry));
    if (targets.back().vertices.size() > 1) continue;
    int& other = first[static_cast<std::size_t>(targets.back().vertices[0])];
    if (other >= 0) entry.fail("is for the same vertex as target " + std::to_string(other));
    other = static_cast<int>(number);
  }
  return targets;
}

std::vector<CGP::internal::Control_point> control_points(const std::vector<Target>& targets,
                                                         const CGP::Mesh_view& surface,
                                                         const std::vector<int>& vertices)
{
  int largest = -1;
  for (const Target& t : targets)
    for (const int v : t.vertices) largest = (std::max)(largest, v);
  for (const int v : vertices) largest = (std::max)(largest, v);
  std::vector<int> number(static_cast<std::size_t>(largest) + 1, -1);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    number[static_cast<std::size_t>(vertices[i])] = static_cast<int>(i);
  std::vector<CGP::internal::Control_point> points;
  for (const Target& t : targets) {
    const std::vector<int> own = kept(t.vertices, number);
    if (own.empty()) continue;
    const auto at_rest =
        CGP::internal::region_control_points(surface, own, Eigen::Affine3d::Identity());
    const Eigen::Vector3d centre = at_rest[0].target;
    const Eigen::Affine3d motion =
        Eigen::Translation3d(centre + t.move) * t.turn * Eigen::Translation3d(-centre);
    for (CGP::internal::Control_point& p :
         CGP::internal::region_control_points(surface, own, motion))
      points.push_back(std::move(p));
  }
  return points;
}

}  // namespace conformal
