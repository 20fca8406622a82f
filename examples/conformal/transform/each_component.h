// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_TRANSFORM_EACH_COMPONENT_H
#define CONFORMAL_TRANSFORM_EACH_COMPONENT_H

#include "conformal/input/Surface_input.h"
#include "conformal/report/Session.h"

#include <functional>
#include <string>
#include <vector>

namespace conformal {

/// one component of a surface, as if there were no other; its elements have their names in the file
struct Component {
  std::string name;  ///< `component 1 (from vertex 17)`
  Surface_input input;
  std::vector<int> vertices, faces;  ///< in the mesh of the whole surface
};

/// Computes new positions of a component, 3 x |V|, and reports to its own session
/// \throws Failure if it does not verify, and exceptions of the library
using Component_work = std::function<CGP::Points(const Component&, Session&)>;

/// \brief Works on all components in sequence, even if some of them fail.
///
/// The reports of their sessions are included at `components/<number>`, and one line is printed for
/// each. The whole is verified if all of them are.
/// \returns the new positions of all vertices
/// \throws Failure with all components that failed and the reasons; exceptions that do not concern
/// a single component (signals, memory) immediately
CGP::Points each_component(const Surface_input& input, Session& session,
                           const Component_work& work);

/// Turns the closed components around that are inside out, as a file with one of them would be.
void turn_components_outward(Surface_input& input);

}  // namespace conformal

#endif
