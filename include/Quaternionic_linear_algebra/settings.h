// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file settings.h
/// \brief Number of threads, and vector units.

#include <Quaternionic_linear_algebra/threads/Thread_team.h>
#include <Quaternionic_linear_algebra/vector_units/Vector_unit.h>
