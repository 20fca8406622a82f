// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <cmath>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \throw Precondition_error unless there are no values or one per vertex, finite and >= 0
void require_values(const Eigen::VectorXd& values, Eigen::Index vertices, bool is_zero_allowed,
                    const std::string& what, const std::string& function)
{
  if (values.size() != 0 && values.size() != vertices)
    throw Precondition_error(function,
                             std::to_string(values.size()) + " " + what +
                                 ", one per vertex is needed: " + std::to_string(vertices));
  for (Eigen::Index v = 0; v < values.size(); ++v)
    if (!std::isfinite(values[v]) || values[v] < 0 || (values[v] == 0 && !is_zero_allowed))
      throw Precondition_error(function, "vertex " + std::to_string(v) + " has the value " +
                                             std::to_string(values[v]) + " among the " + what);
}

void Scale_control::require(Eigen::Index vertices, const std::string& function) const
{
  if (!bound && factors.size() + weights.size() > 0)
    throw Precondition_error(function,
                             "wanted factors of lengths, and weights, need a scale bound");
  if (!bound) return;
  if (!(*bound > 1 && std::isfinite(*bound)))
    throw Precondition_error(
        function, "a scale bound of " + std::to_string(*bound) + "; a number above 1 is needed");
  require_values(factors, vertices, false, "factors of lengths", function);
  require_values(weights, vertices, true, "weights of scales", function);
  if (weights.size() != 0 && weights.maxCoeff() == 0)
    throw Precondition_error(function, "all weights of scales are zero");
}

/// logs of factors of lengths such that the area is kept
Eigen::VectorXd with_area_kept(const Eigen::VectorXd& u, const Eigen::VectorXd& areas,
                               const Surface_part& part)
{
  const double largest = part.largest(u);  // whose square could overflow
  const Eigen::VectorXd sums =
      part.sum(Eigen::Vector2d(areas.dot((2 * (u.array() - largest)).exp().matrix()), areas.sum()));
  const double growth = sums[0] / sums[1];
  return u.array() - largest - std::log(growth) / 2;
}

/// those of 99 % and 99.9 % of the weight: the second is looked for beyond the first alone
inline Eigen::Vector2d tail_quantiles(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                      const Surface_part& part)
{
  const double first = weighted_quantile(values, weights, .99, part), beyond_second = .001;
  std::vector<Eigen::Index> tail;
  for (Eigen::Index v = 0; v < values.size(); ++v)
    if (values[v] >= first) tail.push_back(v);
  const Eigen::VectorXd of_tail = weights(tail);
  const Eigen::Vector2d sums = part.sum(Eigen::Vector2d(weights.sum(), of_tail.sum()));
  const double share = 1 - beyond_second * sums[0] / sums[1];
  return {first, weighted_quantile(values(tail), of_tail, share, part)};
}

Spin_report::Scales measured_scales(const Quaternion_vector<double>& lambda,
                                    const Eigen::VectorXd& areas, const Scale_control& control,
                                    const Surface_part& part)
{
  Eigen::VectorXd u = with_area_kept(log_scales(lambda), areas, part),
                  weights = control.counted_areas.size() > 0 ? control.counted_areas : areas;
  if (control.factors.size() > 0) u -= with_area_kept(control.factors.array().log(), areas, part);
  if (control.weights.size() > 0) weights = (control.weights.array() > 0).select(weights, 0).eval();
  const Eigen::Vector2d up = tail_quantiles(u, weights, part),
                        down = tail_quantiles(-u, weights, part);
  Spin_report::Scales scales;
  scales.bound = control.bound.value_or(0);
  scales.low = std::exp(-down[0]);
  scales.high = std::exp(up[0]);
  scales.tip_low = std::exp(-down[1]);
  scales.tip_high = std::exp(up[1]);
  scales.min = std::exp(part.smallest(u));
  scales.max = std::exp(part.largest(u));
  return scales;
}

Eigen::VectorXd wanted_log_scales(const Eigen::VectorXd& areas, const Scale_control& control)
{
  if (control.factors.size() == 0) return Eigen::VectorXd::Zero(areas.size());
  return control.factors.array().log();
}

void measure_kept(const Eigen::VectorXd& rho, const Eigen::VectorXd& found,
                  const Eigen::VectorXd& areas, bool is_closed, Spin_report::Scales& scales,
                  const Surface_part& part)
{
  const auto product = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return part.sum(areas.dot(a.cwiseProduct(b)));
  };
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(areas.size());
  const auto effect = [&](const Eigen::VectorXd& v) {
    return Eigen::VectorXd(v.array() - (is_closed ? product(v, one) / product(one, one) : 0));
  };
  const Eigen::VectorXd a = effect(rho), b = effect(found);
  const double wanted = std::sqrt(product(a, a)), kept = std::sqrt(product(b, b));
  const double rounding = 1e-12 * std::sqrt(product(rho, rho));
  if (wanted <= rounding) return;
  scales.kept_norm = kept / wanted;
  scales.kept_correlation = kept == 0 ? 0 : product(a, b) / (wanted * kept);
}

}  // namespace Conformal_geometry_processing::internal
