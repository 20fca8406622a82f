// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// All generated meshes of the tests.
#include "support/bounded_meshes.h"
#include "support/mesh_tools.h"
#include "support/polyhedra.h"
#include "support/random.h"
#include "support/scans.h"
#include "support/spheres.h"
#include "support/tori.h"
