// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/algebra/rotor.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

double minimal_kernel_tolerance(const Mesh_view& mesh)
{
  const double pi = std::acos(-1.);
  return boundary_loops(mesh).size() > 1 ? 3 * mean_edge_length(mesh) * pi / face_areas(mesh).sum()
                                         : 0;
}

namespace internal {

/// reports a fault at the boundary if gamma is an eigenvalue that is not zero: the surface then has
/// the constant mean curvature gamma / |lambda|^2
void judge_minimality(const Mesh_view& mesh, const Boundary_condition& condition,
                      Spin_report& report)
{
  if (condition.is_self_adjoint() && std::abs(report.eigenvalue) > greatest_zero(mesh))
    report.boundary_fault = Spin_report::Boundary_fault::not_realizable;
}

Boundary_condition part_of_turn(const Mesh_view& mesh, Boundary_condition condition, double share)
{
  if (condition.targets.cols() == 0) return condition;
  const Boundary_frames b = boundary_frames(mesh);
  for (std::size_t k = 0; k < b.frames.size(); ++k) {
    auto target = condition.targets.col(static_cast<Eigen::Index>(k));
    const Eigen::Vector3d present = b.frames[k] * stable_normalized(condition.direction);
    const Quaternion<double> q = rotor<double>(present, stable_normalized(target));
    const Eigen::Quaterniond turn(q.w, -q.x, -q.y, -q.z);  // v -> turn v conjugate(turn)
    target = Eigen::Quaterniond::Identity().slerp(share, turn) * present;
  }
  return condition;
}

Spin_result spin_towards_minimal_surface(const Mesh_view& mesh, double share,
                                         Spin_transformation_options own,
                                         const std::string& function, const Go_further& go_further)
{
  if (share < 1) own.boundary = part_of_turn(mesh, own.boundary, share);
  const auto rho = Curvature_potential::on_vertices(-share * mean_curvature(mesh));
  Spin_result result = Spin_transformation(mesh, own, function).transform(rho, go_further);
  judge_minimality(mesh, own.boundary, result.report);
  return result;
}

/// the largest share for which that verifies, to 1/64, if all of the way does not
double share_of_way_to_minimal_surface(const Mesh_view& mesh,
                                       const Spin_transformation_options& own,
                                       const std::string& function, const Go_further& go_further)
{
  double exists = 0, fails = 1;
  for (int k = 0; k < 6; ++k) {
    const double share = (exists + fails) / 2;
    const Spin_report r =
        spin_towards_minimal_surface(mesh, share, own, function, go_further).report;
    if (r.cancelled) break;
    (r ? exists : fails) = share;
  }
  return exists;
}

}  // namespace internal

Spin_result spin_to_minimal_surface(const Mesh_view& mesh, Spin_transformation_options own,
                                    const std::string& function,
                                    const internal::Go_further& go_further)
{
  own.exactness = std::nullopt;  // steps would leave the curvature that makes it minimal
  using Branch = Dirac_options::Branch;
  if (own.dirac.branch == Branch::nearest) own.dirac.branch = Branch::zero;
  if (own.dirac.kernel_tolerance == 0) own.dirac.kernel_tolerance = minimal_kernel_tolerance(mesh);
  Spin_result result = internal::spin_towards_minimal_surface(mesh, 1, own, function, go_further);
  if (result.report.fault() == Spin_report::Fault::boundary && !own.mollification)
    result.report.reached =
        internal::share_of_way_to_minimal_surface(mesh, own, function, go_further);
  return result;
}

Associated_family::Associated_family(const Mesh_view& mesh, const std::string& function,
                                     const Spin_solvers& solvers)
    : m_mesh((require_surface(mesh, function), mesh)),
      m_normals(vertex_normals(mesh, internal::Normal_weight::angle)),
      m_reconstruction(m_mesh, vertex_graph(m_mesh), solvers)
{}

internal::Associated_surface Associated_family::operator()(double theta) const
{
  Quaternion_vector<double> lambda(m_mesh.size_of_vertices());
  for (int v = 0; v < m_mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d n = std::sin(theta / 2) * m_normals.col(v);
    lambda[v] = {std::cos(theta / 2), n.x(), n.y(), n.z()};
  }
  const Eigen::MatrixX3d edges = transformed_edges(m_mesh, lambda);
  internal::Associated_surface surface;
  surface.positions = m_reconstruction.positions(edges);
  surface.closure_residual = m_reconstruction.residual(surface.positions, edges);
  return surface;
}

}  // namespace Conformal_geometry_processing
