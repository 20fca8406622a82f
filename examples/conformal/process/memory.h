// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace conformal {

/// \brief From now on the program gets no more memory than this, in GiB: what needs more fails at
/// once, where the system would end the program, or others, without a word. 0: half of the
/// machine's, or of the container's, see `machine_memory()`.
void limit_memory(double gibibytes);

/// what to tell when memory has run out, and what to try; allocates nothing
const char* why_memory_is_out();

}  // namespace conformal
