// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "binding.h"
#include "options.h"
#include "reports.h"
#include "watch.h"

#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/flow/Flow_report.h>

#include <utility>

namespace conformal_python {
namespace {

CGP::Flow_options flow_options(const py::dict& options, const CGP::Mesh_view& mesh,
                               const std::string& function)
{
  using Balance = CGP::Flow_options::Balance;
  using Balancing = CGP::Flow_options::Balancing;
  CGP::Flow_options o;
  take(options, "time_step", o.time_step);
  take(options, "min_time_step", o.min_time_step);
  take(options, "max_steps", o.max_steps);
  take(options, "energy_tolerance", o.energy_tolerance);
  take(options, "fairing", o.fairing);
  take(options, "max_scale", o.surface.scales.bound);
  take(options, "reduced_volume", o.reduced_volume);
  take(options, "filter_weight", o.filter_weight);
  take(options, "filter_order", o.filter_order);
  take(options, "random_seed", o.surface.dirac.random_seed);
  take_surface(options, mesh, function, o.surface);
  choose(
      options, "balance",
      {{"none", Balance::none}, {"initial", Balance::initial}, {"canonical", Balance::canonical}},
      o.balance, function);
  choose(options, "balancing",
         {{"inversion", Balancing::inversion}, {"potential", Balancing::potential}}, o.balancing,
         function);
  o.target_areas = take_numbers(options, "target_areas", function);
  if (o.target_areas.size() > 0) o.balance = Balance::prescribed;
  return o;
}

/// Asks for signals while it computes, and the callback after every step.
class Flow_watch : public CGP::Flow_visitor {
 public:
  explicit Flow_watch(py::object callback) : m_callback(std::move(callback)) {}

  void on_iteration(const CGP::Eigensolver_progress&) { ask(); }

  bool go_further()
  {
    ask();
    return m_goes_on;
  }

  void on_step_end(const CGP::Flow_step_report& step, const CGP::Mesh_view& mesh)
  {
    const py::gil_scoped_acquire lock;
    if (!m_callback.is_none())
      m_goes_on = wants_more(m_callback(as_dict(step), to_rows(mesh.positions())));
  }

 private:
  static void ask()
  {
    const py::gil_scoped_acquire lock;
    raise_signals();
  }

  py::object m_callback;
  bool m_goes_on = true;
};

/// (positions, report)
py::tuple willmore_flow(const Array& V, const Indices& F, const py::dict& options,
                        const py::object& callback)
{
  const std::string function = "willmore_flow";
  const CGP::Mesh_view mesh = mesh_view(V, F, function);
  const CGP::Flow_options own = flow_options(options, mesh, function);
  Flow_watch watch(callback);
  CGP::Flow_report report;
  const CGP::Points positions = without_lock([&] {
    CGP::Conformal_willmore_flow flow(mesh, own, {}, function);
    report = flow.run(watch);
    return flow.positions();
  });
  return py::make_tuple(to_rows(positions), as_dict(report));
}

}  // namespace

void add_flow(py::module_& m)
{
  using py::arg;
  m.def("willmore_flow", &willmore_flow, arg("V"), arg("F"), arg("options"), arg("callback"));
}

}  // namespace conformal_python
