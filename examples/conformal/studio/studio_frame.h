// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace conformal {

/// a page of the studio without its surfaces: its scripts, three.js and the kernels
struct Studio_frame {
  std::string begin, end;  ///< before and behind the surfaces
  std::string version;     ///< of the program that it is from
};

/// Where an installed program finds a page: `../share/conformal/studio.html` as seen from the
/// program, or below the prefix of its build where the system does not tell where the program is.
std::string installed_studio_page();

/// \brief The frame of a page that this or another program has written.
/// \throws Read_error if the file is none
Studio_frame read_studio_frame(const std::string& path);

/// \brief The frame of new pages: of the given page, of this program, or of the installed page.
/// \param page empty: none is given
/// \throws Failure if there is none, with the command that builds one
Studio_frame studio_frame(const std::string& page);

}  // namespace conformal
