// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "option_groups.h"

#include "conformal/process/Failure.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/conformal_modulus.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <complex>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace conformal {
namespace {

const char* const harmonic_about =
    "Finds the harmonic 1-forms of a closed surface with handles, two for each, and their tangent\n"
    "fields; of a torus also the conformal modulus. -o writes a PLY file with the fields as\n"
    "face properties harmonic_0_x, harmonic_0_y, harmonic_0_z, ..., in 1/length.\n"
    "Example: conformal harmonic torus.obj -o torus_fields.ply --json torus.json";

struct Harmonic_options {
  std::string input;
  std::optional<int> form;  ///< the only one to be written
};

void add_options(CLI::App& command, Harmonic_options& harmonic, Common_options& common)
{
  add_input(command, harmonic.input);
  add_repair(command, common);
  add_components(command, common);
  add_mesh_output(command, common, "the mesh with the fields");
  command.add_option("--form", harmonic.form, "write only this one, counted from 0")
      ->check(CLI::NonNegativeNumber);
}

Files files(const Harmonic_options& harmonic)
{
  return {{"the input", harmonic.input, Named_file::Role::replaceable}};
}

void require_handles(const Surface_input& input, const Harmonic_options& options)
{
  require_closed_surface(input);
  const int genus = CGP::topology(input.mesh).genus;
  if (genus == 0)
    throw unsuitable(options.input, "has genus 0 and so no harmonic fields, wanted handles");
  if (options.form && *options.form >= 2 * genus)
    throw Failure(Exit_code::usage, options.input + ": there is no form " +
                                        std::to_string(*options.form) + "; try: --form 0 to " +
                                        std::to_string(2 * genus - 1));
}

// The certificate: forms are harmonic if they are closed, coclosed and orthonormal, independently
// of their computation.
struct Residuals {
  double closed, coclosed, orthonormal;

  double largest() const
  {
    const Eigen::Array3d all(closed, coclosed, orthonormal);
    return all.maxCoeff<Eigen::PropagateNaN>();
  }
};

Residuals residuals(const CGP::Mesh_view& mesh, const CGP::Hodge_decomposition& hodge)
{
  const Eigen::MatrixXd& forms = hodge.harmonic_basis().one_forms;
  const double size = forms.cwiseAbs().maxCoeff();
  const Eigen::MatrixXd around_faces = CGP::exterior_derivative_1(mesh) * forms;
  const Eigen::MatrixXd around_vertices = CGP::codifferential(mesh, hodge.weights(), forms);
  const Eigen::MatrixXd products = forms.transpose() * hodge.weights().asDiagonal() * forms;
  const auto identity = Eigen::MatrixXd::Identity(products.rows(), products.cols());
  return {around_faces.cwiseAbs().maxCoeff() / size, around_vertices.cwiseAbs().maxCoeff() / size,
          (products - identity).cwiseAbs().maxCoeff()};
}

std::string fault_of(const Residuals& found)
{
  const double limit = 1e-6;
  if (found.largest() <= limit) return {};
  return "the residual of the forms is " + text_of(found.largest(), 3) + ", more than " +
         text_of(limit, 3) + "; try: a mesh without slivers";
}

// How well the equations hold, and the class of a torus.
void tell(const CGP::Mesh_view& mesh, const CGP::Hodge_decomposition& hodge, const Residuals& found,
          Report& report)
{
  const CGP::Harmonic_basis& basis = hodge.harmonic_basis();
  report.tell("result/genus", "genus", basis.genus());
  report.tell("result/forms", "harmonic forms", basis.size());
  report.tell("result/closed_residual", "sum around faces, relative", found.closed);
  report.tell("result/coclosed_residual", "sum around vertices, relative", found.coclosed);
  report.tell("result/orthonormal_residual", "deviation from orthonormal", found.orthonormal);
  if (basis.genus() != 1) return;
  const std::complex<double> tau = CGP::conformal_modulus(mesh, basis);
  const std::string place = "result/conformal_modulus/";
  report.tell(place + "real", "conformal modulus, real part", tau.real());
  report.tell(place + "imaginary", "conformal modulus, imaginary part", tau.imag());
}

/// Sets a field as three face properties; a polygon has the mean of its triangles.
/// \param mesh the triangles in the frame of the computation
void set_field(const Surface_input& input, const CGP::Mesh_view& mesh, const CGP::Points& field,
               const std::string& name, Surface_file& file)
{
  const char* const suffixes[] = {"_x", "_y", "_z"};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> sum(file.polygons.size(), 0), area(sum);
    for (int t = 0; t < mesh.size_of_faces(); ++t) {
      const auto f = static_cast<std::size_t>(input.face_in_file[static_cast<std::size_t>(t)]);
      const double A = mesh.double_area_vector(t).norm();
      sum[f] += A * field(axis, t);
      area[f] += A;
    }
    for (std::size_t f = 0; f < sum.size(); ++f) sum[f] /= area[f];
    set_property(file.faces, name + suffixes[axis], sum);
  }
}

/// fields on the whole surface in 1/length, by their numbers; zero on components without them
using Fields = std::map<int, CGP::Points>;

void add_fields(const Surface_input& whole, const Component& component,
                const CGP::Harmonic_basis& basis, const std::optional<int>& form, Fields& fields)
{
  const double unit = CGP::internal::Normalized_frame(component.input.mesh.positions()).unit();
  for (int i = 0; i < basis.size(); ++i) {
    if (form.value_or(i) != i) continue;
    const auto [place, is_new] = fields.try_emplace(i);
    if (is_new) place->second = CGP::Points::Zero(3, whole.mesh.size_of_faces());
    place->second(Eigen::indexing::all, component.faces) =
        basis.fields[static_cast<std::size_t>(i)] / unit;
  }
}

Surface_file file_with_fields(const Surface_input& input, const Fields& fields)
{
  Surface_file file = input.file;
  const CGP::Mesh_view mesh = CGP::internal::in_own_frame(input.mesh);
  for (const auto& [number, field] : fields)
    set_field(input, mesh, field, "harmonic_" + std::to_string(number), file);
  return file;
}

CGP::Harmonic_basis find(const Surface_input& input, const Harmonic_options& options,
                         Session& session)
{
  require_handles(input, options);
  const CGP::Mesh_view mesh = CGP::internal::in_own_frame(input.mesh);
  const CGP::Hodge_decomposition hodge(mesh, "harmonic");
  throw_if_interrupted();
  session.end_stage("solve");
  const Residuals found = residuals(mesh, hodge);
  tell(mesh, hodge, found, session.report());
  Evidence evidence{mesh.positions()};
  evidence.fault = fault_of(found);
  session.conclude(judge(evidence, {}, ""), On_fault::refuse);
  session.end_stage("measure");
  return hodge.harmonic_basis();
}

void harmonic(const Harmonic_options& options, Session& session)
{
  const std::string& output = session.options().output;
  if (!output.empty()) require_writable(output);
  const Surface_input input = read_suitable_surface(options.input, session);
  Fields fields;
  each_component(input, session, [&](const Component& component, Session& own) {
    add_fields(input, component, find(component.input, options, own), options.form, fields);
  });
  if (output.empty()) return;
  write_mesh(output, file_with_fields(input, fields), session);
  session.end_stage("write");
}

}  // namespace

Command harmonic_command()
{
  return make_command<Harmonic_options>("harmonic", harmonic_about, add_options, files, harmonic);
}

}  // namespace conformal
