// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_twice.h"

#include "Search_watch.h"

#include "conformal/report/verification.h"

#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <exception>
#include <functional>
#include <utility>

namespace conformal {
namespace {

/// a solution, or the error in place of it, and why it would be refused
struct Attempt {
  Spin_solution solution;
  std::exception_ptr error;
  std::string fault;
};

Attempt attempt(const CGP::Mesh_view& mesh, const Spin_problem& problem, Session& session,
                const std::string& words)
{
  Attempt result;
  try {
    Search_watch watch(session, problem.request.dirac.tolerance, words);
    result.solution = {solve_spin(mesh, problem, std::ref(watch))};
    watch.end(result.solution.report);
    result.fault =
        objection(result.solution.report, result.solution.positions, problem.request.limits, "");
  } catch (const CGP::Error& error) {  // the matrices of thin faces may not be definite
    const auto* of_solver = dynamic_cast<const CGP::Solver_error*>(&error);
    if (of_solver != nullptr && CGP::is_out_of_memory(*of_solver)) throw;
    result.error = std::current_exception();
    result.fault = error.message();
  }
  return result;
}

Spin_solution solution_of(Attempt&& attempt)
{
  if (attempt.error) std::rethrow_exception(attempt.error);
  return std::move(attempt.solution);
}

std::string without_advice(const std::string& fault)
{
  return fault.substr(0, fault.find("; try"));
}

/// whether the second attempt would solve what the first one has solved, as all triangles are well
/// shaped already; also where their Delaunay triangulation is refused, as it would be again
bool is_same_surface(const CGP::Mesh_view& mesh, double mollification)
{
  try {
    const CGP::Delaunay_view view(mesh, mollification);
    return view.number_of_flips() == 0 && view.added_length() == 0 &&
           view.size_of_sheets() == mesh.size_of_faces();  // no cap at the boundary is split
  } catch (const CGP::Precondition_error&) {
    return true;
  }
}

}  // namespace

Spin_solution solve_twice(const CGP::Mesh_view& mesh, const Spin_problem& problem, Session& session,
                          const std::string& words)
{
  Attempt first = attempt(mesh, problem, session, words);
  if (first.fault.empty() || !problem.second_try || is_same_surface(mesh, *problem.second_try))
    return solution_of(std::move(first));
  Spin_problem again = problem;
  again.request.mollification = problem.second_try;
  Attempt second = attempt(mesh, again, session, words + "as with --mollify, ");
  if (!second.fault.empty()) return solution_of(std::move(first));
  second.solution.note = "solved as with --mollify: without, " + without_advice(first.fault);
  return solution_of(std::move(second));
}

}  // namespace conformal
