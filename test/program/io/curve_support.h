// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Plane_curve.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <stdexcept>
#include <string>

/// Common functions of the tests of curve files.
namespace program_test {

inline Eigen::Matrix2Xd points(std::initializer_list<Eigen::Vector2d> list)
{
  return conformal::columns(std::vector<Eigen::Vector2d>(list));
}

/// the action throws, and the message has the words
template <class Action>
::testing::AssertionResult refuses(Action action, const std::string& words)
{
  try {
    action();
  } catch (const std::runtime_error& error) {
    if (std::string(error.what()).find(words) != std::string::npos)
      return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << error.what();
  }
  return ::testing::AssertionFailure() << "accepted";
}

}  // namespace program_test
