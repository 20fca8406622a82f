// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "spin_in_parts.h"

#include "Checkpoint.h"
#include "Distributed_spin.h"
#include "Stl_ranges.h"
#include "collective.h"

#include "conformal/commands/keyed_options.h"
#include "conformal/commands/option_groups.h"
#include "conformal/input/Expression.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"
#include "conformal/report/certificate.h"
#include "conformal/transform/Search_watch.h"
#include "conformal/transform/solve_spin.h"

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace conformal::mpi {
namespace {

const char* const spin_about =
    "Deforms a surface of any shape conformally so that its mean curvature changes by rho, as\n"
    "`conformal spin` does, on many processes, which may be on many machines:\n"
    "  mpirun -n 4 conformal-mpi spin BIG.ply --rho-expression ... -o OUT.ply\n"
    "No process ever has more than its part of the surface. The input is a binary PLY with\n"
    "triangles, or a binary STL. The output is a PLY with its properties, and quality and rho.\n"
    "Lengths change by a factor of 2 at most (--max-scale), on 98 % of the area.\n"
    "Handles, and several boundaries, are not kept closed: such surfaces need --open-handles.\n"
    "rho is in 1/length of the normalised frame (the middle of the bounding box at 0, its "
    "diagonal\n"
    "2), positive rho bulges outward, constants have no effect.\n"
    "PETSC_OPTIONS has options for the solvers, as -conformal_eps_monitor.\n"
    "Every five minutes the state of the work is kept in OUTPUT.checkpoint, from which --resume "
    "goes\n"
    "on, on any number of processes; it goes when the output is written.\n"
    "A result that does not verify is not written, and the exit code is 1.\n"
    "Example: mpirun -n 2 conformal-mpi spin bear.ply --rho-expression 'sin(5*y)' -o out.ply";

/// what every process has to know
struct Job {
  std::string input, output, expression, solver = "factor";
  double amplitude = 1, checkpoint = 300;
  double tolerance = CGP::Dirac_options().tolerance;
  int iterations = 1000;  // they may be cycles of grids, not solves with a factor
  bool resume = false, open_handles = false;
  double bound = 0;                         // 0: none
  double quasi_conformal = 0, closure = 0;  // limits, which the search aims at

  NLOHMANN_DEFINE_TYPE_INTRUSIVE(Job, input, output, expression, solver, amplitude, tolerance,
                                 checkpoint, iterations, resume, open_handles, bound,
                                 quasi_conformal, closure)

  /// what a checkpoint depends on
  std::string problem() const { return nlohmann::json{input, expression, amplitude, bound}.dump(); }
};

struct Options {
  Job job;
  std::optional<double> bound = CGP::internal::default_scale_bound;
  bool force = false;
  CGP::Spin_report::Limits limits;
};

/// what the first process tells of the result
struct Told {
  CGP::Spin_report report;
  int vertices = 0, faces = 0, border_vertices = 0;
  bool has_factor = true;
  std::vector<double> megabytes, own_vertices, other_vertices;  // of each process
  std::vector<std::string> left_out;
};

/// whether the result is written, decided by the first process
using Approve = std::function<bool(const Told&)>;

double peak_megabytes()
{
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// the frame of users, see `User_frame`
struct Frame {
  Eigen::Vector3d center;
  double unit = 1;

  explicit Frame(const CGP::Points& own)
  {
    Eigen::Vector3d low, high;
    for (Eigen::Index c = 0; c < 3; ++c) {
      low[c] = smallest(own.row(c).minCoeff());
      high[c] = largest(own.row(c).maxCoeff());
    }
    center = low / 2 + high / 2;
    unit = (high / 2 - low / 2).stableNorm();
  }
};

/// rho at the vertices of the part, in the frame of users
Eigen::VectorXd rho_of(const Job& job, const Distributed_mesh& mesh, const Frame& frame)
{
  const int own = mesh.own_vertices();
  Eigen::MatrixXd rho(1, mesh.mesh().size_of_vertices());
  together([&] {
    Expression expression(job.expression);
    const CGP::Points normals = CGP::vertex_normals(mesh.mesh());  // right at the own vertices
    for (int v = 0; v < own; ++v) {
      const Eigen::Vector3d p = (mesh.mesh().position(v) - frame.center) / frame.unit;
      rho(0, v) = job.amplitude * expression(p, normals.col(v));
      if (!std::isfinite(rho(0, v)))
        throw unsuitable(job.input,
                         "rho is not a finite number everywhere; try: a formula that is");
    }
  });
  mesh.update(rho);
  return rho.row(0);
}

void write(const Job& job, const Ply_ranges& file, const Distributed_mesh& mesh,
           const Distributed_result& result, const Eigen::VectorXd& rho)
{
  Eigen::MatrixXd own(5, mesh.own_vertices());
  own.topRows(3) = result.positions;
  own.row(3) = result.quality.transpose();
  own.row(4) = rho.head(mesh.own_vertices()).transpose();
  const Eigen::MatrixXd rows = mesh.in_order_of_file(own);
  const auto column = [&](const std::string& name, Eigen::Index r) {
    const Eigen::VectorXd values = rows.row(r);
    return Column{name, {values.data(), values.data() + values.size()}};
  };
  file.write(job.output, Ranges::equal(file.vertices()), rows.topRows(3),
             {column("quality", 3), column("rho", 4)});
}

void do_job(const Job& job, const Go_further& go_further, const Approve& approve)
{
  const std::unique_ptr<const Ply_ranges> file = surface_ranges(job.input);
  const Distributed_mesh mesh(*file, job.open_handles);
  const Frame frame(mesh.mesh().positions().leftCols(mesh.own_vertices()));
  const Eigen::VectorXd rho = rho_of(job, mesh, frame);
  Spin_request request;
  if (job.bound > 0) request.bound = job.bound;
  request.dirac.tolerance = job.tolerance;
  request.dirac.max_iterations = job.iterations;
  request.limits.map.quasi_conformal = job.quasi_conformal;
  request.limits.closure = job.closure;
  const Solution_plan plan(mesh, job.solver == "multigrid");
  Checkpoint checkpoint(job.output + ".checkpoint", job.problem(), job.checkpoint);
  const Search_state start = job.resume ? checkpoint.read(mesh) : Search_state();
  const auto save = [&](const Search_state& state) { checkpoint.save(mesh, state); };
  const Distributed_result result =
      transform(mesh, plan, rho / frame.unit, request, start, save, go_further);
  const Told told{result.report,
                  file->vertices(),
                  file->faces(),
                  plan.border.ranges.total(),
                  plan.has_factor,
                  of_each(peak_megabytes()),
                  of_each(mesh.own_vertices()),
                  of_each(mesh.mesh().size_of_vertices() - mesh.own_vertices()),
                  file->left_out()};
  if (!broadcast(rank() == 0 && approve(told))) return;
  write(job, *file, mesh, result, rho);
  checkpoint.remove();
}

void tell(const Told& told, Session& session)
{
  Report& report = session.report();
  report.tell("input/vertices", "vertices", told.vertices);
  report.tell("input/faces", "faces", told.faces);
  report.set("result/processes/count", processes());
  report.set("result/processes/vertices", Report::Value(told.own_vertices));
  report.set("result/processes/other_vertices", Report::Value(told.other_vertices));
  report.set("result/processes/peak_megabytes", Report::Value(told.megabytes));
  report.set("result/processes/border_vertices", told.border_vertices);
  report.set("result/processes/solver", told.has_factor ? "factor" : "multigrid");
  const auto [least, most] = std::minmax_element(told.megabytes.begin(), told.megabytes.end());
  report.show("peak memory of a process (MB)", text_of(*least, 4) + " to " + text_of(*most, 4));
  for (const std::string& what : told.left_out) session.note("left out: " + what);
  session.begin_stage();
  tell_certificate(told.report, told.faces, session.outcome());
}

void add_options(CLI::App& command, Options& options, Common_options& common)
{
  Job& job = options.job;
  command.add_option("input", job.input, "binary PLY file with triangles, or binary STL file")
      ->required();
  command
      .add_option("--rho-expression", job.expression,
                  "formula in x y z (normalised frame), nx ny nz (outward normal), pi, e")
      ->required()
      ->check(formula);
  command.add_option("--amplitude", job.amplitude, "multiplies rho")->capture_default_str();
  add_output(command, common)->required();
  add_max_scale(command, options.bound);
  command.add_flag("--open-handles", job.open_handles,
                   "also with handles or several boundaries, which rho shears");
  advanced(command)
      .add_option("--tolerance", job.tolerance, "of the eigenvector, without a bound on lengths")
      ->check(between_zero_and_one)
      ->capture_default_str();
  advanced(command)
      .add_option("--iterations", job.iterations, "at most so many of the eigensolver")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  advanced(command)
      .add_option("--solver", job.solver,
                  "factor, or multigrid, which is taken in any case where the borders between the "
                  "parts are long")
      ->check(CLI::IsMember({"factor", "multigrid"}))
      ->capture_default_str();
  advanced(command)
      .add_option("--checkpoint", job.checkpoint, "seconds between two checkpoints")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_flag("--resume", job.resume, "go on from OUTPUT.checkpoint");
  add_limits(command, options.limits, options.force);
}

Files files(const Options& options)
{
  return {{"the input", options.job.input, Named_file::Role::replaceable}};
}

void run(const Options& options, Session& session)
{
  Job job = options.job;
  job.output = session.options().output;
  job.bound = options.bound.value_or(0);
  job.quasi_conformal = options.limits.map.quasi_conformal;
  job.closure = options.limits.closure;
  session.set_input(job.input);
  broadcast(nlohmann::json(job).dump());
  Verdict verdict;
  const auto approve = [&](const Told& told) {
    tell(told, session);
    const CGP::Points none(3, 0);  // whether they are finite is known on all processes
    verdict = judge(Evidence{none, told.report}, options.limits, "a weaker rho");
    return signal_received() == 0 && !told.report.cancelled &&
           (verdict.is_verified() || options.force);
  };
  Search_watch watch(session, job.tolerance);
  do_job(job, std::ref(watch), approve);
  watch.end();
  session.conclude(verdict, on_fault(options.force));
}

}  // namespace

Command spin_command()
{
  return make_command<Options>("spin", spin_about, add_options, files, run);
}

void serve()
{
  const Go_further always = [](const CGP::Eigensolver_progress&) { return true; };
  for (std::string text = broadcast(std::string()); !text.empty();
       text = broadcast(std::string())) {
    try {
      do_job(nlohmann::json::parse(text).get<Job>(), always, {});
    } catch (const std::exception&) {  // the first process tells it
    }
  }
}

void dismiss()
{
  broadcast(std::string());
}

}  // namespace conformal::mpi
