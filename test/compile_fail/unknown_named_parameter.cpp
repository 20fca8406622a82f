// expect: integrate.*unknown named parameter
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/core/named_parameters.h>

namespace CGP = Conformal_geometry_processing;

template <typename CGAL_NP_TEMPLATE_PARAMETERS>
void integrate(const CGAL_NP_CLASS&)
{
  static_assert(CGP::internal::only_known_parameters<CGAL_NP_CLASS, CGP::internal_np::time_step_t>,
                "integrate(): unknown named parameter");
}

int main()
{
  integrate(CGP::parameters::time_step(.1));
  integrate(CGP::parameters::time_step(.1).tolerance(1e-3));  // never looked at: a mistake
}
