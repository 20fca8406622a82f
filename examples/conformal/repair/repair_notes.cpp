// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "repair.h"

#include "conformal/process/text.h"

namespace conformal {

bool Repair::has_changed_anything() const
{
  return merged_points + removed_faces + shortened_faces + bridged_faces + turned_faces +
             cut_edges + added_vertices + removed_vertices + flipped_edges + collapsed_edges +
             removed_flat_faces >
         0;
}

std::vector<std::string> Repair::notes() const
{
  std::vector<std::string> notes;
  const auto tell = [&](int count, const char* noun, const std::string& what) {
    if (count > 0)
      notes.push_back("repaired: " + count_of(static_cast<std::size_t>(count), noun) + what);
  };
  tell(merged_points, "vertex", " merged into others at the same place");
  tell(removed_faces, "face", " removed: repeated, or with fewer than three different corners");
  tell(shortened_faces, "face", " left with fewer corners: one came twice in a row");
  tell(bridged_faces, "polygon", " with a corner twice cut into triangles, as a bridge to a hole");
  tell(turned_faces, "face", " turned around, to agree with the others");
  tell(flipped_edges, "edge", " flipped, so that a face of area zero splits its neighbour");
  tell(collapsed_edges, "edge",
       " collapsed at faces of area zero where no flip helps, the longest " +
           text_of(longest_collapsed_edge, 3) + " long");
  tell(removed_flat_faces, "face",
       " of area zero removed: at the boundary or a cut, or of a component without an area");
  tell(cut_polygons, "polygon", " cut into triangles for that");
  tell(cut_edges, "edge", " cut open where more than two faces met, or two could not agree");
  tell(added_vertices, "vertex", " added where fans of faces only touched");
  tell(removed_vertices, "vertex", " without a face removed");
  return notes;
}

}  // namespace conformal
