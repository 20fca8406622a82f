// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "each_component.h"

#include "Component_failures.h"

#include "conformal/process/text.h"

#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string>
#include <vector>

namespace conformal {
namespace {

using CGP::internal::Mesh_component;

void add_row(const Component_outcome& component, std::size_t number, Grid& grid)
{
  const auto& verdict = component.outcome.verdict;
  const bool has_map = verdict && verdict->map;
  const auto& t = component.topology;
  grid.add({std::to_string(number), std::to_string(component.first_vertex),
            std::to_string(t.vertices), std::to_string(t.faces), std::to_string(t.boundary_loops),
            std::to_string(t.genus), has_map ? text_of(verdict->map->quasi_conformal.mean, 5) : "-",
            has_map ? std::to_string(verdict->map->flipped_faces) : "-",
            verdict && verdict->closure_residual ? text_of(*verdict->closure_residual, 5) : "-",
            verdict && verdict->is_verified() ? "yes" : "no"});
}

/// the text with names of elements in the file for those that the library gives to a component's
std::string with_names(std::string text, const Surface_input& input)
{
  const std::regex edge("\\bedge (\\d+)-(\\d+)"), corners("\\(vertices (\\d+), (\\d+), (\\d+)\\)"),
      element("\\b(vertex|face) (\\d{1,9})\\b");
  text = std::regex_replace(text, edge, "the edge from vertex $1 to vertex $2");
  text = std::regex_replace(text, corners, "(vertex $1, vertex $2, vertex $3)");
  std::string named;
  std::string::const_iterator rest = text.cbegin();
  for (std::sregex_iterator i(text.begin(), text.end(), element), end; i != end; ++i) {
    const bool is_vertex = (*i)[1] == "vertex";
    const int number = std::stoi((*i)[2]);
    const std::size_t all = is_vertex ? input.vertex_in_file.size() : input.face_in_file.size();
    named.append(rest, (*i)[0].first);
    if (static_cast<std::size_t>(number) >= all)
      named += (*i)[0];
    else
      named += is_vertex ? name_of_vertex(input, number) : name_of_face(input, number);
    rest = (*i)[0].second;
  }
  return named.append(rest, text.cend());
}

/// Messages of the library count the elements of what it is given, which has an order of its own.
void do_work(const Component& component, const Component_work& work, Session& session)
{
  try {
    work(component, session);
  } catch (const CGP::Precondition_error& error) {
    throw CGP::Precondition_error(error.function(), with_names(error.message(), component.input));
  }
}

/// Works on one component, and adds what came of it to the outcome of the whole.
void attempt(const std::string& name, const Component& component, const Component_work& work,
             Component_failures& failures, Session& session)
{
  Session own(session.options(), name + ": ");
  own.outcome().command = session.outcome().command;
  own.set_input(session.input());
  Outcome& outcome = own.outcome();
  outcome.error = failures.attempt(name, [&] { do_work(component, work, own); });
  for (const std::string& note : outcome.notes) session.note(own.part() + note);
  session.outcome().seconds.add(outcome.seconds);
  const std::vector<int>& in_file = component.input.vertex_in_file;
  session.outcome().components.push_back({*std::min_element(in_file.begin(), in_file.end()),
                                          CGP::topology(component.input.mesh), std::move(outcome)});
}

void tell_components(Session& session)
{
  Grid grid({"component", "from vertex", "vertices", "faces", "loops", "genus", "mean Q", "flipped",
             "closure", "verified"});
  const std::vector<Component_outcome>& all = session.outcome().components;
  int verified = 0;
  for (std::size_t c = 0; c < all.size(); ++c) {
    add_row(all[c], c, grid);
    const std::optional<Verdict>& verdict = all[c].outcome.verdict;
    verified += verdict && verdict->is_verified();
  }
  session.report().set("result/components", static_cast<int>(all.size()));
  session.report().set("result/verified_components", verified);
  session.report().show(grid);
}

/// the first verdict on a component that does not verify, and yet is forced; or a good one
Verdict worst_verdict(const std::vector<Component_outcome>& components)
{
  for (const Component_outcome& component : components)
    if (const auto& verdict = component.outcome.verdict; verdict && !verdict->is_verified())
      return *verdict;
  return {};
}

void conclude(const Component_failures& failures, Session& session)
{
  const bool keeps_going = session.options().keep_going && !failures.are_all();
  if (failures.size() == 0)
    session.outcome().verdict = worst_verdict(session.outcome().components);
  else if (keeps_going)
    session.conclude({failures.text()}, On_fault::fail_in_the_end);
  else
    throw failures.failure();
}

}  // namespace

void each_component(const Surface_input& input, Session& session, const Component_work& work)
{
  session.end_stage("prepare");
  if (!session.options().each_component) {
    Mesh_component all = in_morton_order(whole_of(input.mesh));
    const Surface_input own = reordered(all, input);
    return do_work({own, all.vertices, all.faces}, work, session);
  }
  const std::vector<Mesh_component> parts = CGP::mesh_components(input.mesh);
  Component_failures failures(session.input(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string name = "component " + std::to_string(i) + " (from " +
                             name_of_vertex(input, parts[i].vertices.front()) + ")";
    const Mesh_component part = in_morton_order(parts[i]);
    const Surface_input own = input_of(part, input);
    attempt(name, {own, part.vertices, part.faces}, work, failures, session);
  }
  tell_components(session);
  conclude(failures, session);
  session.begin_stage();
}

}  // namespace conformal
