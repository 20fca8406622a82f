// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "numbered_outputs.h"

#include "conformal/io/file/snapshot_path.h"
#include "conformal/process/Failure.h"
#include "conformal/transform/write_result.h"

#include <filesystem>
#include <system_error>

namespace conformal {

void require_new_files(const std::string& noun, const std::string& output, int count,
                       const std::vector<std::string>& inputs)
{
  for (int k = 0; k < count; ++k) {
    for (const std::string& input : inputs) {
      std::error_code ignored;
      if (std::filesystem::equivalent(snapshot_path(output, k), input, ignored))
        throw Failure(Exit_code::usage, noun + " " + std::to_string(k) + " would be written over " +
                                            input + "; try: another name for the output");
    }
    require_writable(snapshot_path(output, k));
  }
}

}  // namespace conformal
