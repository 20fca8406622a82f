// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/Realised_curvature.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <ostream>

namespace Conformal_geometry_processing {

namespace internal {

/// \brief The numbers that verify `snap_to_conformal_class()`.
struct [[nodiscard]] Class_snap_report {
  bool converged = false;
  int iterations = 0, factorizations = 0;
  /// changes of log length cross-ratios from the reference, in the end of the positions as written
  Length_cross_ratio_change initial_length_cross_ratio, length_cross_ratio;
  double displacement = 0;  ///< root mean square over the vertices, by the diagonal of the mesh

  /// whether the surface is in the class; if not, nothing was written
  explicit operator bool() const { return converged; }
};

}  // namespace internal

/// \ingroup PkgSpin
/// \brief the numbers that verify a spin transformation. The realised change of curvature is rho +
/// gamma. If the transformation was cancelled, nothing has been written.
struct [[nodiscard]] Spin_report : internal::Dirac_evidence {
  /// why a surface with prescribed boundary data is not reliable
  enum class Boundary_fault {
    none,
    not_realizable,  ///< no conformal surface has the data: the singular value of D - rho does not
                     ///< tend to 0
    does_not_close,  ///< the edges do not close up
    degenerate,      ///< lambda nearly vanishes somewhere
    ambiguous  ///< two surfaces have the data about equally well, on a mesh that is too coarse
               ///< around holes
  };

  int steps = 1;       ///< number of transformations, or of steps on the way of control points
  double reached = 1;  ///< completed share of the path to rho, in [0, 1]; where a minimal
                       ///< surface does not exist, the share of the way that does
  double missing_share = 0;   ///< norm of the part of rho that was left out because the surface
                              ///< would not have closed up, relative to that of rho
  double realised_share = 1;  ///< the root of 1 - missing_share^2, the norm of the part of rho that
                              ///< the new surface has where the two parts are orthogonal, relative
                              ///< to that of rho; of control points, the share of their way
  double added_share = 0;     ///< with prescribed directions around holes: norm of the rho that was
                              ///< added so that the surface closes up, relative to that of the mean
                              ///< curvature of a round sphere, sqrt(4 pi), for any size
  double period_defect = 0;   ///< remaining period defect, relative to the edges, sum of the steps
  /// the largest that counts as closed, see `internal::Period_limit`, where no step ensures it
  double period_limit = std::numeric_limits<double>::infinity();

  /// with prescribed directions at a boundary: the angles between the directions of the new surface
  /// and the targets, in radians
  struct Direction_error {
    double mean = 0, max = 0;
  } direction_error;
  Boundary_fault boundary_fault = Boundary_fault::none;

  /// of the disk of the same area, in lengths of the mesh; 0 for closed surfaces
  double radius = 0;
  /// with prescribed binormals rho says what the mean curvature is, up to gamma, which has a limit
  bool limits_gamma = false;
  /// without a unit
  double gamma_radius() const { return eigenvalue * radius; }

  /// with prescribed positions at a boundary, which no conformal surface need have: the edges need
  /// not close up either, and the distortion of the map is what counts
  bool has_positions = false;

  /// the distances from prescribed positions, of the boundary or of control points, in lengths
  struct Position_error {
    double mean = 0, max = 0;
  } position_error;

  /// how the intrinsic triangulation was built; over several steps the maximum, but what was
  /// measured in the first
  struct Mollification {
    double share = 0;          ///< requested share; 0: none
    int thin_faces = 0;        ///< whose edges formed no triangle, or nearly none
    int longer_edges = 0;      ///< number of lengthened edges: all or none
    double added_length = 0;   ///< of each edge, in the unit of the mesh
    int flipped_edges = 0;     ///< until all edges were Delaunay
    int measured_faces = 0;    ///< on which `conformality` is measured: the `well_shaped_faces()`
    double measured_area = 0;  ///< their share of the area; at least 95 %
  } mollification;

  /// what control of scale did; lengths are relative to the wanted factors
  struct Scales {
    /// what tips of less than 1 % of the area may have more than the bound
    static constexpr double wider_at_tips = 1.5;

    double bound = 0;          ///< requested; 0: none
    double low = 1, high = 1;  ///< factors of lengths, of 1 % to 99 % of the area
    double tip_low = 1,
           tip_high = 1;          ///< of .1 % to 99.9 %, for which the bound is 1.5 times wider
    double min = 1, max = 1;      ///< and of all of it
    double weight = 0;            ///< w of `internal::Relaxed_scales`; 0: the bound is slack
    double kept_norm = 1;         ///< norm of the realised rho relative to that of rho
    double kept_correlation = 1;  ///< between the two; on closed surfaces without their means

    /// the largest log factor relative to the log of its bound, at most 1 within both; 0 without
    double excess() const;

    /// norm of the difference between the realised rho and rho, relative to that of rho
    double distance() const;
  } scales;

  /// how the surface was moved to its exact discrete conformal class; none if that was not
  /// requested
  std::optional<internal::Class_snap_report> exact_class;

  /// how far the new edges are from conjugate(lambda) df lambda, relative; over several steps from
  /// the first surface to the last
  double closure_residual = 0;
  Conformality conformality;  ///< of the map from the old surface to the new one
  double min_spin_ratio = 0;  ///< min |lambda| / max |lambda|; near zero if the map degenerates

  /// what the positions have of the given rho, all of it, before a part was left out; none if it is
  /// constant, or the method has another aim than rho
  std::optional<Realised_curvature> realised_curvature;

  /// of the map on the collar of a region of interest, where the deformation fades out; none if
  /// there is no region
  std::optional<Conformality> collar;

  /// wall clock seconds
  struct Seconds : internal::Dirac_evidence::Seconds {
    double setup = 0;           ///< checks, pattern, ordering, symbolic analysis: once per mesh
    double exactness = 0;       ///< constraints that keep loops closed: once per surface with loops
    double reconstruction = 0;  ///< includes the factorization of the Laplacian the first time
    double certificate = 0;
  } seconds;

  /// bounds of what counts as success
  struct Limits {
    double residual = 1e-4;           ///< whatever tolerance was requested
    double closure = 0.1;             ///< of `closure_residual`
    double direction_error = 0.1745;  ///< of its mean, in radians: ten degrees
    double gamma_radius = 2;       ///< of the modulus of that: of the round sphere of the same area
    double realised_share = 0.44;  ///< the least: the norm left out is .9 then
    double kept_norm = 0.1;        ///< the least of `Scales::kept_norm`
    double agreement = 0.5;        ///< of `Realised_curvature::agreement()`, see `falls_short()`
    double opposition = 0.2;       ///< the largest of minus the agreement
    Conformality::Limits map;
  };

  /// what `fault()` objects to
  enum class Fault {
    none,
    cancelled,
    not_finite,    ///< of the eigenvalue: the mesh is too small or too thin
    not_solved,    ///< the equation
    boundary,      ///< see `boundary_fault`
    directions,    ///< those at the boundary are missed
    curvature,     ///< the constant gamma, which prescribed binormals add to rho, is too large
    nothing_left,  ///< no part of rho keeps the handles closed
    left_out,      ///< too much of rho is left out
    open,          ///< the new edges do not close up, or not around handles and holes
    scales,        ///< lengths change by more than the bound
    exact_class,   ///< the exact discrete conformal class is not reached
    map,           ///< see `Conformality::fault()`
    unrealised     ///< the curvature has changed against rho, as beyond a resonance
  };

  /// \brief the verdict: the first reason why the transformation is not what was requested, or
  /// none.
  ///
  /// It is solved, conformal, closed, not flipped, not collapsed, and has the boundary, the better
  /// part of the rho, and the exact conformal class that were requested.
  Fault fault() const;

  /// \brief whether the curvature of the new surface has changed otherwise than requested:
  /// `Realised_curvature::agreement()` is below its limit. A warning, and a fault only where it is
  /// against rho.
  bool falls_short() const;

  Limits limits;  ///< what `fault()` and the conversion to `bool` judge by

  /// whether there is no `fault()`
  explicit operator bool() const;
};

/// \relates Spin_report
const char* to_string(Spin_report::Boundary_fault fault);

/// \relates Spin_report
const char* to_string(Spin_report::Fault fault);

namespace internal {

void append(Spin_report::Mollification& all, const Spin_report::Mollification& next);

/// adds what another transformation has cost; the setup is shared
void add_costs(Spin_report& all, const Spin_report& next);

}  // namespace internal

/// \relates Spin_report
/// \brief appends the report of a second transformation to that of the first: sums costs, and takes
/// the worse evidence. What is measured from start to end (conformality, spins, and the closure, of
/// which only the worst step is known here) is left to the caller.
void append(Spin_report& all, const Spin_report& next);

/// \relates Spin_report
/// writes the certificate, one fact per line
std::ostream& operator<<(std::ostream& out, const Spin_report& r);

/// \ingroup PkgSpin
/// \brief a model of `SpinVisitor` that does nothing; derive from it to override a function.
///
/// Pass it by `parameters::visitor(std::ref(v))`. Its exceptions are propagated and leave the mesh
/// unchanged.
struct Spin_visitor {
  /// called after every iteration of the eigensolver
  void on_iteration(const Eigensolver_progress&) {}

  /// called after every iteration: false cancels, and nothing is written
  bool go_further() { return true; }
};

/// \ingroup PkgSpin
/// \brief the expected normals of the faces after a spin transformation: rotated by the mean spin
/// of their corners, 3 x |F|, not normalised.
Points rotated_normals(const Mesh_view& mesh, const Quaternion_vector<double>& lambda);

namespace internal {

/// \brief Writes into the report how conformal the map from a surface to new positions is, and the
/// ratio of the smallest to the largest spin; if a position is not finite, the result has not
/// converged.
/// \param measured the surface, or its part with positive areas
/// \param f 3 x |V| \param lambda |V|
/// \pre squares of areas neither overflow nor underflow
void certify(const Mesh_view& measured, const Points& f, const Quaternion_vector<double>& lambda,
             Spin_report& report, const Surface_part& part = {});

/// of the disk of the same area
double radius_of_area(const Surface_ref& surface, const Surface_part& part = {});

}  // namespace internal

/// \ingroup PkgSpin
/// \brief the largest singular value of D - rho, in 1/length, that the edge length explains: if
/// gamma is a misfit, larger values belong to no surface.
double greatest_misfit(const Surface_ref& surface, const internal::Surface_part& part = {});

/// \ingroup PkgSpin
/// \brief the largest modulus of gamma, in 1/length, that the edge length explains where the exact
/// eigenvalue is zero: it is of second order.
double greatest_zero(const Surface_ref& surface);

/// \ingroup PkgSpin
/// \brief whether the data prescribed at the boundary can be realised.
///
/// For realisable data, the singular value sigma of D - rho tends to zero with the edge length h;
/// otherwise it does not. The residual of the positions tends to zero with h^2. If the residual is
/// small, a surface with this boundary exists nevertheless, and its curvature is rho up to sigma;
/// prescribed binormals, which realise rho up to gamma, guarantee no more. Non-planar tangents are
/// of this kind: exact solutions are exceptional [CGP 5.7], good approximations are not.
///
/// \param sigma in 1/length; zero if it is a true eigenvalue and not a misfit
/// \param report contains the measured quantities
Spin_report::Boundary_fault boundary_fault(const Surface_ref& surface, double sigma,
                                           const Spin_report& report,
                                           const internal::Surface_part& part = {});

}  // namespace Conformal_geometry_processing
