// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

/// \file version.h
/// \brief The version of the library, which is also read by CMake.

#define CONFORMAL_GEOMETRY_PROCESSING_VERSION_MAJOR 1
#define CONFORMAL_GEOMETRY_PROCESSING_VERSION_MINOR 0
#define CONFORMAL_GEOMETRY_PROCESSING_VERSION_PATCH 0
#define CONFORMAL_GEOMETRY_PROCESSING_VERSION "1.0.0"
