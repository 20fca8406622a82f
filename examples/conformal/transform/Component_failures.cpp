// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Component_failures.h"

#include <Quaternionic_linear_algebra/exceptions.h>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

std::string Component_failures::attempt(const std::string& name, const std::function<void()>& work)
{
  std::string reason = reason_of(work);
  const std::string path = m_path + ": ";
  if (reason.compare(0, path.size(), path) == 0) reason.erase(0, path.size());
  if (!reason.empty()) m_reasons.add(name, reason);
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
    return error.message();
  } catch (const CGP::Solver_error& error) {
    if (CGP::is_out_of_memory(error)) throw;
    return error.message();
  }
  return {};
}

std::string Component_failures::text() const
{
  return std::to_string(size()) + " of " + std::to_string(m_components) +
         (m_components == 1 ? " component failed; " : " components failed; ") + m_reasons.text();
}

Failure Component_failures::failure() const
{
  return {m_is_of_data ? Exit_code::unsuitable : Exit_code::failed, m_path + ": " + text()};
}

}  // namespace conformal
