// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_OPTIONS_H
#define CONFORMAL_OPTIONS_H

#include <optional>
#include <string>

namespace conformal {

/// what every command takes
struct Common_options {
  std::string output, json, html;
  int threads = 1;
  unsigned seed = 0;
  double tolerance = 1e-8;
  bool quiet = false, strict = false, repair = false;
  bool each_component = false;  ///< works on one component after the other
};

enum class Projection { uv, x, y, z, sphere };

enum class Filter_choice { none, low_pass, high_pass, unsharp };

/// Filter for rho; missing values have defaults
struct Filter_request {
  Filter_choice choice = Filter_choice::none;
  std::optional<bool> on_image;  ///< else on the surface; undecided: where there is one
  std::optional<double> radius;  ///< in pixels, on the image
  std::optional<double> weight;  ///< on the surface, as for `CGP::internal::Curvature_filter`
  std::optional<int> order;      ///< likewise
  std::optional<double> amount;  ///< of the unsharp mask
};

/// where rho comes from: exactly one of the four is not empty
struct Rho_options {
  std::string expression, property, file, image;
  Projection projection = Projection::uv;
  double amplitude = 1;
  std::optional<bool> on_faces;  ///< undecided: vertices, or whatever the data fit
  Filter_request filter;
};

/// beyond these the result of a transformation does not verify
struct Verification_limits {
  double closure = 0.1;          ///< of the relative closure residual
  double quasi_conformal = 1.5;  ///< of the mean Q
  double flipped = 0.01;         ///< of the share of flipped faces
  double direction_error = 10;   ///< of directions at the boundary, the mean in degrees
};

struct Info_options {
  std::string input;
};

/// what stays as it is at the boundary of a surface that has one
enum class Boundary_choice { free, tangents, binormals };

struct Spin_options {
  std::string input;
  Rho_options rho;
  Boundary_choice boundary = Boundary_choice::free;
  std::string lambda;  ///< the name of the vertex properties, none if empty
  bool generalized = false, force = false;
  std::optional<double> mollification;  ///< share of the mean edge; 0: never, none: where it helps
  bool open_handles = false;  ///< rho is applied as it is, though it opens handles and holes
  std::optional<double> max_period_defect;  ///< of handles and holes; none: by the edge length
  std::string solver = "native";            // or cholmod, eigen
  Verification_limits limits;
};

enum class Balance_choice { none, initial, canonical };

struct Flow_options {
  std::string input;
  int steps = 10;
  double time_step = 1;  ///< the largest; 2 is the limit of stability
  double filter_weight = 0;
  int filter_order = 1;
  Balance_choice balance = Balance_choice::none;
  Boundary_choice boundary = Boundary_choice::free;
  std::optional<double> mollification;      ///< share of the mean edge; none or 0: no triangulation
  std::optional<double> max_period_defect;  ///< in each step, as for `Spin_options`
  int every = 0;                            ///< steps from a snapshot to the next; none if zero
  bool force = false;
  Verification_limits limits;
};

/// The prescribed boundary: exactly one member is not empty
struct Prescription_options {
  std::string tangents_from, binormals_from, positions_from;  ///< files with meshes
  std::string curve;                                          ///< a file with points
  std::string tangent_rotation, binormal_tilt;                ///< formulas
};

struct Boundary_options {
  Spin_options spin;  ///< what this command has in common with that; without a source, rho is 0
  Prescription_options prescription;
  bool minimal = false;  ///< rho is -H
};

struct Fit_options {
  Spin_options spin;  ///< what this command has in common with that; input is the source
  std::string target;
  double blend = 0;   ///< 0 is conformal, 1 nearest to the target
  std::string scale;  ///< a formula of factors for the scales of the target, none if empty
  Boundary_choice boundary = Boundary_choice::tangents;  ///< taken from the target; not free
};

struct Blend_options {
  Spin_options spin;         ///< what this command has in common with that; input is A
  std::string other, onto;   ///< files; the difference is added to A, unless there is another
  double t = 0.5, from = 0;  ///< of B - A; the first of the frames
  int frames = 0;
};

enum class Flatten_method { spectral, dirac };

struct Flatten_options {
  std::string input;
  Flatten_method method = Flatten_method::spectral;
  bool planar = false;       ///< by curvature instead
  bool planar_mesh = false;  ///< writes the flat mesh
  bool all_loops = false;    ///< the spread of all boundary loops is kept
  double tolerance = 1e-6;   ///< of the spectral map
  bool force = false;
  Verification_limits limits;
};

struct Harmonic_options {
  std::string input;
  std::optional<int> form;  ///< the only one to be written
};

struct Compare_options {
  std::string before, after;
};

}  // namespace conformal

#endif
