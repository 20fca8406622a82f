// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Checkpoint.h"

#include "Common_file.h"

#include "conformal/process/Failure.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <utility>

namespace conformal::mpi {
namespace {

/// what precedes the rows: a line of JSON, filled up to a fixed length
std::string head_of(const std::string& job, const Search_state& state)
{
  const std::size_t length = 65536;
  std::string text =
      nlohmann::json{{"job", job}, {"numbers", state.numbers}, {"rows", state.values.rows()}}
          .dump();
  if (text.size() >= length) throw Failure(Exit_code::usage, "the formula is too long");
  text.resize(length - 1, ' ');
  return text + "\n";
}

/// where the values of a vertex begin, in bytes
std::size_t place(const Eigen::MatrixXd& values, int vertex)
{
  return sizeof(double) * static_cast<std::size_t>(values.rows() * vertex);
}

}  // namespace

Checkpoint::Checkpoint(std::string path, std::string job, double seconds)
    : m_path(std::move(path)), m_job(std::move(job)), m_seconds(seconds)
{}

Search_state Checkpoint::read(const Distributed_mesh& mesh) const
{
  const Ranges ranges = Ranges::equal(mesh.ranges().total());
  Search_state state;
  Eigen::MatrixXd ordered;
  together([&] {
    std::ifstream file(m_path, std::ios::binary);
    std::string head;
    if (!std::getline(file, head)) throw Read_error(m_path, 0, "there is no checkpoint to resume");
    const auto json = nlohmann::json::parse(head, nullptr, false);
    if (json.is_discarded() || json.value("job", "") != m_job || !json.contains("rows"))
      throw Failure(Exit_code::unsuitable,
                    m_path + " is the checkpoint of another run; try: without --resume");
    for (const auto& number : json["numbers"])  // what is not finite is null
      state.numbers.push_back(number.is_null() ? HUGE_VAL : number.get<double>());
    ordered.resize(json["rows"].get<Eigen::Index>(), ranges.size());
    file.seekg(static_cast<std::streamoff>(head.size() + 1 + place(ordered, ranges.begin())));
    const std::size_t size = place(ordered, ranges.size());
    if (!file.read(reinterpret_cast<char*>(ordered.data()), static_cast<std::streamsize>(size)))
      throw Read_error(m_path, 0, "it ends early");
  });
  state.values = mesh.from_order_of_file(ordered);
  return state;
}

void Checkpoint::save(const Distributed_mesh& mesh, const Search_state& state)
{
  const std::chrono::duration<double> age = Clock::now() - m_last;
  if (!broadcast(age.count() >= m_seconds)) return;
  const Ranges ranges = Ranges::equal(mesh.ranges().total());
  const Eigen::MatrixXd ordered = mesh.in_order_of_file(state.values);
  const std::string head = head_of(m_job, state);
  Common_file file(m_path);
  together([&] {
    if (rank() == 0) file.write_at(0, {head.begin(), head.end()});
    const char* const first = reinterpret_cast<const char*>(ordered.data());
    file.write_at(head.size() + place(ordered, ranges.begin()),
                  {first, first + place(ordered, ranges.size())});
  });
  file.commit();
  m_last = Clock::now();
}

void Checkpoint::remove() const
{
  if (rank() == 0) std::remove(m_path.c_str());
}

}  // namespace conformal::mpi
