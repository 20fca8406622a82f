// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Surface_input.h"

#include <vector>

namespace conformal {

/// where closed surfaces are cut
struct Cut_options {
  int tips = 0;             ///< how many are looked for, on each component; 0: it is not cut
  bool finds_tips = false;  ///< twice as many, where the image does not verify with them
  std::vector<int> cones;   ///< vertices of the file that the cut reaches, in place of tips

  bool is_cut() const { return tips > 0 || !cones.empty(); }
};

/// A surface whose vertices have copies along cuts
struct Cut_surface {
  Surface_input input;
  std::vector<int> origin;  ///< of each vertex of `input.file`: its number in the file before
};

/// \brief Cuts closed components to disks, along the edges of the file; see `cut_graph()`.
/// \throws Failure if a cone is no vertex of a closed component, or alone on a sphere
Cut_surface cut_open(const Surface_input& input, const Cut_options& options);

}  // namespace conformal
