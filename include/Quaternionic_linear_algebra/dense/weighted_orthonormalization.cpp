// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/dense/weighted_orthonormalization.h>

#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <string>

namespace Conformal_geometry_processing {
namespace internal {

void require_weighted_functions(const Eigen::MatrixXd& functions, const Eigen::VectorXd& weights)
{
  const std::string name = "weighted_orthonormalization";
  if (functions.rows() != weights.size())
    throw Precondition_error(name, std::to_string(weights.size()) +
                                       " weights, one per row of the functions is needed: " +
                                       std::to_string(functions.rows()));
  for (Eigen::Index i = 0; i < weights.size(); ++i)
    if (!(weights[i] > 0) || !std::isfinite(weights[i]))
      throw Precondition_error(name, "weight " + std::to_string(i) + " is " +
                                         std::to_string(weights[i]) +
                                         "; positive numbers are needed");
  for (Eigen::Index j = 0; j < functions.cols(); ++j)
    if (!functions.col(j).allFinite())
      throw Precondition_error(name,
                               "function " + std::to_string(j) + " has a value that is not finite");
}

/// calls visit(first, rows) for blocks of rows that fit into the cache
template <class Visitor>
void for_blocks_of_rows(Eigen::Index size, const Visitor& visit)
{
  const Eigen::Index block = 512;
  for (Eigen::Index first = 0; first < size; first += block)
    visit(first, (std::min)(block, size - first));
}

Eigen::MatrixXd weighted_gram_matrix(const Eigen::MatrixXd& functions,
                                     const Eigen::VectorXd& weights)
{
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(functions.cols(), functions.cols());
  for_blocks_of_rows(functions.rows(), [&](Eigen::Index first, Eigen::Index rows) {
    const auto block = functions.middleRows(first, rows);
    const Eigen::MatrixXd weighted = weights.segment(first, rows).asDiagonal() * block;
    gram.noalias() += block.transpose() * weighted;
  });
  return gram;
}

/// the functions times a matrix with at most as many columns, in their memory
void replace_by_combinations(Eigen::MatrixXd& functions, const Eigen::MatrixXd& coefficients)
{
  for_blocks_of_rows(functions.rows(), [&](Eigen::Index first, Eigen::Index rows) {
    const Eigen::MatrixXd combinations = functions.middleRows(first, rows) * coefficients;
    functions.block(first, 0, rows, coefficients.cols()) = combinations;
  });
  functions.conservativeResize(Eigen::NoChange, coefficients.cols());
}

}  // namespace internal

Eigen::MatrixXd weighted_orthonormalization(Eigen::MatrixXd functions,
                                            const Eigen::VectorXd& weights, double threshold)
{
  internal::require_weighted_functions(functions, weights);
  if (functions.cols() == 0) return functions;
  const auto gram =
      hermitian_eigen_decomposition(internal::weighted_gram_matrix(functions, weights));
  const Eigen::VectorXd squared = gram.values.reverse();  // decreasing
  const Eigen::Index rank =
      squared[0] > 0 ? (squared.array() > threshold * threshold * squared[0]).count() : 0;
  internal::replace_by_combinations(functions,
                                    gram.vectors.rowwise().reverse().leftCols(rank) *
                                        squared.head(rank).cwiseSqrt().cwiseInverse().asDiagonal());
  // The basis is already orthonormal up to rounding / threshold^2, so that the Cholesky factor of
  // its Gram matrix, near the identity, makes it so and hardly mixes the directions.
  const Eigen::MatrixXd rest = internal::weighted_gram_matrix(functions, weights);
  rest.llt().matrixU().solveInPlace<Eigen::OnTheRight>(functions);
  return functions;
}

Eigen::VectorXd project_out(const Eigen::MatrixXd& basis, const Eigen::VectorXd& weights,
                            Eigen::VectorXd v)
{
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::VectorXd coefficients = basis.transpose() * weights.cwiseProduct(v);
    v -= basis * coefficients;
  }
  return v;
}

}  // namespace Conformal_geometry_processing
