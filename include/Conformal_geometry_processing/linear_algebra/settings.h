// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file linear_algebra/settings.h
/// \brief Number of threads, and vector units.

#include <Conformal_geometry_processing/linear_algebra/vector_units/Vector_unit.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>
