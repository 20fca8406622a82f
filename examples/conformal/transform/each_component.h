// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Component.h"

#include "conformal/report/Session.h"

#include <functional>

namespace conformal {

/// Works on a component, and tells what came of it in its own session.
/// \throws Failure if it does not verify, and exceptions of the library
using Component_work = std::function<void(const Component&, Session&)>;

/// \brief Works on the whole surface or, with `--each-component`, on all components in sequence,
/// even if some of them fail.
///
/// The outcomes of components are included in that of the session, and one line is printed for
/// each. The whole is verified if all of them are. With `--advanced keep-going` the command goes on
/// with those that are, if there are any, and fails in the end. \throws Failure with all components
/// that failed and the reasons; exceptions that do not concern a single component (signals, memory)
/// immediately
void each_component(const Surface_input& input, Session& session, const Component_work& work);

}  // namespace conformal
