// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_SUPPORT_MESHES_H
#define TEST_SUPPORT_MESHES_H

/// All generated meshes of the tests.
#include "support/bounded_meshes.h"
#include "support/mesh_tools.h"
#include "support/polyhedra.h"
#include "support/random.h"
#include "support/scans.h"
#include "support/spheres.h"
#include "support/tori.h"

#endif
