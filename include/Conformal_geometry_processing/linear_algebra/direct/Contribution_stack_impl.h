// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_CONTRIBUTION_STACK_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_CONTRIBUTION_STACK_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Contribution_stack.h>

#include <algorithm>
#include <cstdint>

namespace Conformal_geometry_processing {

// For a single supernode: its update uses the free space of one of the inner regions, and more.
CGP_INLINE void internal::Contribution_stack::enclose(Region& own, std::int64_t update,
                                                      const Region& roomiest)
{
  own.padding = (std::max<std::int64_t>)(0, update - roomiest.spare());
  own.size += own.padding;
  own.kept = update;
}

// The region with most free space lies where the update of the enclosing supernode is placed.
CGP_INLINE void internal::Contribution_stack::put(Region& own, bool is_roomiest, Region& around,
                                                  bool is_at_low_end)
{
  if (is_roomiest)
    own.begin = is_at_low_end ? around.begin + around.padding
                              : around.begin + around.size - around.padding - own.size;
  else
    own.begin = around.next;
  if (!is_roomiest) around.next += own.size;
}

}  // namespace Conformal_geometry_processing

#endif
