// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "near_names.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace conformal {
namespace {

std::string lower(std::string_view text)
{
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

/// the Damerau-Levenshtein distance, in which no letters are inserted between exchanged ones
std::size_t edits(const std::string& a, const std::string& b)
{
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t k = 0; k <= b.size(); ++k) {
      d[i][k] = i == 0 ? k : i;
      if (i == 0 || k == 0) continue;
      const std::size_t replaced = d[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
      d[i][k] = std::min({d[i - 1][k] + 1, d[i][k - 1] + 1, replaced});
      const bool is_exchanged = i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1];
      if (is_exchanged) d[i][k] = std::min(d[i][k], d[i - 2][k - 2] + 1);
    }
  return d[a.size()][b.size()];
}

bool has_word(const std::string& name, const std::string& word)
{
  return word.size() > 1 && (name.compare(0, word.size(), word) == 0 ||
                             ('-' + name + '-').find('-' + word + '-') != std::string::npos);
}

}  // namespace

std::vector<std::string> near_names(std::string_view wrong, const std::vector<std::string>& names)
{
  constexpr std::size_t most = 5;
  const std::string own = lower(wrong);
  const std::size_t allowed = std::max<std::size_t>(1, own.size() / 3);
  std::vector<std::pair<std::size_t, std::string>> found;
  for (const std::string& name : names) {
    const std::string other = lower(name);
    const std::size_t distance = has_word(other, own) ? 0 : edits(own, other);
    if (distance <= allowed && distance < own.size()) found.emplace_back(distance, name);
  }
  const auto is_nearer = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::stable_sort(found.begin(), found.end(), is_nearer);
  std::vector<std::string> nearest;
  for (std::size_t i = 0; i < std::min(most, found.size()); ++i) nearest.push_back(found[i].second);
  return nearest;
}

std::string listed(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace conformal
