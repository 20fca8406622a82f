// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief one name for the solvers of all scalars: what the named parameter `sparse_solver` takes.
///
/// Headers of these types:
/// - `Conformal_geometry_processing::Quaternion`,
///   `Quaternionic_linear_algebra/algebra/Quaternion.h`
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Supernodal_solver_traits`, the default,}
/// \cgalHasModels{`Conformal_geometry_processing::Cholmod_hermitian_solver_traits`,}
/// \cgalHasModels{`Conformal_geometry_processing::Petsc_hermitian_solver_traits`,}
/// \cgalHasModels{`Conformal_geometry_processing::Eigen_hermitian_solver_traits`.}
/// \cgalHasModelsEnd
class SparseHermitianSolverTraits {
 public:
  /// a model of `SparseHermitianSolver` for `Scalar`, which is `double` or `Quaternion<double>`,
  /// and for parameterizations also `std::complex<double>`
  template <class Scalar>
  using Solver = unspecified_type;
};
