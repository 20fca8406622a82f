// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run.h"

int main(int argc, char** argv)
{
  return conformal::run(argc, argv);
}
