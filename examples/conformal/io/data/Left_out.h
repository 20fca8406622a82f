// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// \brief What a reader leaves out of a file: a note for each kind of things, with their number and
/// the place of the first one.
///
/// All readers follow one rule: wrong geometry is refused; wrong attributes and what the program
/// does not know are left out, with a note.
class Left_out {
 public:
  /// \param where as in `line 7`; empty for what is there once
  void add(std::string_view what, const std::string& where);

  std::vector<std::string> notes() const;

 private:
  struct Kind {
    std::string what, first;
    std::size_t count;
  };

  std::vector<Kind> m_kinds;
};

}  // namespace conformal
