// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// \brief An eigensolver whose type is forgotten: the library's own by default; any model converts
/// to it.
/// \cgalModels{SparseHermitianEigensolverTraits}
class Eigensolver_ref {
 public:
  using Matrix = Hermitian_sparse_matrix<Quaternion<double>>;
  using Solver = Solver_ref<Quaternion<double>>;
  using Vectors = Block<Quaternion<double>>;

  Eigensolver_ref() : Eigensolver_ref(Lobpcg_eigensolver_traits()) {}

  /// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`; converts
  template <class EigensolverTraits,
            class = std::enable_if_t<!std::is_same_v<EigensolverTraits, Eigensolver_ref>>>
  Eigensolver_ref(EigensolverTraits traits)
      : m_find([traits = std::move(traits)](
                   const Matrix& A, const Vector<double>& N, const Solver& solver, Vectors x0,
                   const Eigensolver_options& options, const Go_further& go_further) {
          return traits(A, N, solver, std::move(x0), options, std::cref(go_further));
        })
  {}

  Eigensolver_result operator()(const Matrix& A, const Vector<double>& N, const Solver& solver,
                                Vectors x0, const Eigensolver_options& options = {},
                                const Go_further& go_further = Always_go_further()) const
  {
    return m_find(A, N, solver, std::move(x0), options, go_further);
  }

 private:
  std::function<Eigensolver_result(const Matrix&, const Vector<double>&, const Solver&, Vectors,
                                   const Eigensolver_options&, const Go_further&)>
      m_find;
};

}  // namespace Conformal_geometry_processing::internal
