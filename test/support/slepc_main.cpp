// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The tests over PETSc and SLEPc: every process runs all of them, side by side.
#include <slepcsys.h>

#include <gtest/gtest.h>

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  if (SlepcInitialize(&argc, &argv, nullptr, nullptr) != 0) return 1;
  const int result = RUN_ALL_TESTS();
  return SlepcFinalize() != 0 ? 1 : result;
}
