// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <cstddef>

namespace Conformal_geometry_processing {

Block<Quaternion<double>> internal::Ritz_panel::gram(const Block<Quaternion<double>>& A,
                                                     const Block<Quaternion<double>>& B) const
{
  return gram_matrix(A, B, coefficients);
}

Vector<double> internal::Ritz_panel::values() const
{
  Vector<double> theta(size());
  for (Eigen::Index j = 0; j < size(); ++j)
    theta[j] = inner_product(v.col(j), kv.col(j)).w / inner_product(v.col(j), nv.col(j)).w;
  return theta;
}

void internal::Ritz_panel::residual(Block<Quaternion<double>>& r) const
{
  const Vector<double> theta = values();
  r.resize(v.rows(), size());
  const std::ptrdiff_t least = 8192;
  for_each_range(v.rows(), least, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (Eigen::Index j = 0; j < size(); ++j)
      r.col(j).segment(first, last - first) = kv.col(j).segment(first, last - first) -
                                              theta[j] * nv.col(j).segment(first, last - first);
  });
}

void replace_by_combination(internal::Ritz_panel& p, const Block<Quaternion<double>>& C,
                            const internal::Ritz_panel& q, const Block<Quaternion<double>>& D)
{
  replace_by_combination(p.v, C, q.v, D);
  replace_by_combination(p.kv, C, q.kv, D);
  replace_by_combination(p.nv, C, q.nv, D);
}

Block<Quaternion<double>> internal::orthonormal_combinations(const Block<Quaternion<double>>& G)
{
  using Vectors = Block<Quaternion<double>>;
  const double degenerate = 1e-11;
  const Eigen::Index d = G.cols();
  Vectors C(d, 0);
  for (Eigen::Index j = 0; j < d; ++j) {
    Vectors c = Vectors::Constant(d, 1, {});
    c(j, 0).w = 1 / std::sqrt(G(j, j).w);
    for (int pass = 0; pass < 2; ++pass)
      add_combination(c, C, Vectors(-gram_matrix(C, combination(G, c))));
    const double rest = inner_product(c.col(0), combination(G, c).col(0)).w;
    if (!(rest > degenerate) || !std::isfinite(rest)) continue;
    C.conservativeResize(d, C.cols() + 1);
    C.rightCols(1) = c;
    scale_column(C, C.cols() - 1, 1 / std::sqrt(rest));
  }
  return C;
}

void orthonormalize(internal::Ritz_panel& p)
{
  const auto C = internal::orthonormal_combinations(p.gram(p.v, p.nv));
  for (auto* part : p.parts()) *part = combination(*part, C);
}

internal::Eigensolver_convergence::Eigensolver_convergence(std::string function,
                                                           const Eigensolver_options& options,
                                                           const Block<Quaternion<double>>& x0)
    : m_function(std::move(function)), m_options(options)
{
  if (options.wanted < 1 || options.wanted > x0.cols())
    throw Precondition_error(m_function,
                             "cannot find " + std::to_string(options.wanted) + " eigenpairs with " +
                                 std::to_string(x0.cols()) +
                                 " initial vectors: wanted at least one vector for each");
}

internal::Ritz_panel internal::Eigensolver_convergence::initial(internal::Ritz_panel x) const
{
  const Eigen::Index columns = x.size();
  orthonormalize(x);
  if (x.size() != columns)
    throw Precondition_error(
        m_function, "the " + std::to_string(columns) + " initial vectors depend on each other");
  return x;
}

Eigensolver_result internal::Eigensolver_convergence::result()
{
  m_result.iterations = m_iterations;
  if (m_result.values.size() == 1 && std::isfinite(m_next))
    m_result.gap = (std::max)(m_next - m_result.values[0], 0.);
  if (m_result.values.size() > 1) m_result.gap = m_result.values[1] - m_result.values[0];
  return std::move(m_result);
}

bool internal::Eigensolver_convergence::has_adapted(const Block<Quaternion<double>>& vectors)
{
  if (!m_options.adapt ||
      !m_options.adapt(Eigensolver_progress{m_iterations, m_value, m_estimate, &vectors}))
    return false;
  m_best = m_lowest = m_next = std::numeric_limits<double>::infinity();
  m_idle = 0;
  return true;
}

// Uses only the component of T r orthogonal to x; the component along x consists of rounding
// errors, which a nearly singular K would amplify.
Vector<double> internal::Eigensolver_convergence::error_estimates(
    const internal::Ritz_panel& x, const Block<Quaternion<double>>& r,
    const Block<Quaternion<double>>& Tr) const
{
  Vector<double> estimates(x.size());
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const Quaternion<double> along =
        reduced_to(x.coefficients, inner_product(x.nv.col(j), Tr.col(j)));
    const double squared =
        (inner_product(r.col(j), Tr.col(j)) - inner_product(r.col(j), x.v.col(j)) * along).w;
    estimates[j] = std::sqrt((std::max)(squared, 0.0)) / m_options.scale;
    if (std::isnan(squared)) estimates[j] = squared;
  }
  return estimates;
}

void internal::Eigensolver_convergence::note_progress(const Block<Quaternion<double>>& vectors,
                                                      const Vector<double>& values,
                                                      const Vector<double>& estimates,
                                                      double estimate)
{
  const double rounding =
      1e-14 * (std::max)(std::abs(values[0]), m_options.scale * m_options.scale);
  const bool lower = values[0] < m_lowest - rounding, better = estimate < m_best;
  m_idle = lower || better ? 0 : m_idle + 1;
  m_lowest = (std::min)(m_lowest, values[0]);
  if (!better) return;
  m_best = estimate;
  m_result.vectors = vectors;
  m_result.estimates = estimates;
  m_result.values = values;
}

}  // namespace Conformal_geometry_processing
