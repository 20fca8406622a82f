// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// A user's program over the component cholmod.
#include <Conformal_geometry_processing/version.h>

#include <cholmod.h>

#include <iostream>

#ifndef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#error "the component cholmod must announce itself"
#endif

int main()
{
  cholmod_common common;
  const bool right = cholmod_start(&common) != 0;
  cholmod_finish(&common);
  std::cout << "cholmod " << CONFORMAL_GEOMETRY_PROCESSING_VERSION << (right ? "" : " is wrong")
            << '\n';
  return right ? 0 : 1;
}
