// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Component_failures.h"

#include <Conformal_geometry_processing/exceptions.h>

#include <algorithm>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

std::string Component_failures::attempt(const std::string& name, const std::function<void()>& work)
{
  std::string reason = reason_of(work);
  const std::string path = m_path + ": ";
  if (reason.compare(0, path.size(), path) == 0) reason.erase(0, path.size());
  if (!reason.empty()) add(name, reason);
  return reason;
}

std::string Component_failures::reason_of(const std::function<void()>& work)
{
  try {
    work();
  } catch (const Failure& failure) {
    if (failure.code() != Exit_code::failed && failure.code() != Exit_code::unsuitable) throw;
    m_is_of_data |= failure.code() == Exit_code::unsuitable;
    return failure.what();
  } catch (const CGP::Precondition_error& error) {
    m_is_of_data = true;
    return error.message() + " (elements are counted within the component)";
  } catch (const CGP::Solver_error& error) {
    if (error.message().find("out of memory") != std::string::npos) throw;
    return error.message();
  }
  return {};
}

void Component_failures::add(const std::string& name, const std::string& reason)
{
  ++m_count;
  const auto known = std::find_if(m_names_of_reasons.begin(), m_names_of_reasons.end(),
                                  [&](const auto& entry) { return entry.first == reason; });
  if (known != m_names_of_reasons.end())
    known->second += ", " + name;
  else
    m_names_of_reasons.emplace_back(reason, name);
}

void Component_failures::throw_if_any() const
{
  if (m_count == 0) return;
  std::string all = m_path + ": " + std::to_string(m_count) + " of " + std::to_string(m_size) +
                    (m_size == 1 ? " component failed" : " components failed");
  for (const auto& [reason, names] : m_names_of_reasons) all += "; " + names + ": " + reason;
  throw Failure(m_is_of_data ? Exit_code::unsuitable : Exit_code::failed, all);
}

}  // namespace conformal
