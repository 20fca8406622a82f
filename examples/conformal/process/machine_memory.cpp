// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "machine_memory.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

namespace conformal {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// the number in a file; what is not a number, such as "max", is no limit
double limit_in(const std::string& file)
{
  std::ifstream in(file);
  double bytes = 0;
  return in >> bytes && bytes > 0 ? bytes : unlimited;
}

/// the least limit of a group and of all groups around it
double least_limit(const std::string& tree, std::string group, const std::string& file)
{
  double least = unlimited;
  for (;;) {
    least = (std::min)(least, limit_in(tree + group + "/" + file));
    if (group.empty()) return least;
    group.resize((std::min)(group.rfind('/'), group.size() - 1));
  }
}

bool has_memory(const std::string& controllers)
{
  std::istringstream names(controllers);
  for (std::string name; std::getline(names, name, ',');)
    if (name == "memory") return true;
  return false;
}

}  // namespace

double memory_of_control_groups(const std::string& root)
{
  const std::string tree = root + "/sys/fs/cgroup";
  std::ifstream groups(root + "/proc/self/cgroup");
  double least = unlimited;
  std::string number, controllers, group;  // a line is, for instance, 4:memory:/user/1
  while (std::getline(groups, number, ':') && std::getline(groups, controllers, ':') &&
         std::getline(groups, group)) {
    if (has_memory(controllers))
      least = (std::min)(least, least_limit(tree + "/memory", group, "memory.limit_in_bytes"));
    if (!controllers.empty()) continue;
    for (const char* const mount : {"", "/unified"})  // beside version 1 it is the latter
      least = (std::min)(least, least_limit(tree + mount, group, "memory.max"));
  }
  return least;
}

double machine_memory()
{
  const double physical =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  return (std::min)(physical, memory_of_control_groups());
}

}  // namespace conformal
