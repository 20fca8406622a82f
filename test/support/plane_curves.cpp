// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/plane_curves.h"

namespace cgp_test {

Curve flower(int m)
{
  return sampled(
      m, [](double t) { return std::polar(1 + .3 * std::cos(5 * t) + .1 * std::sin(3 * t), t); });
}

Curve ellipse(int m)
{
  return sampled(m, [](double t) { return std::complex(3 * std::cos(t), std::sin(t)); });
}

Curve figure_eight(int m)
{
  return sampled(m, [](double t) {
    return std::complex(2 * std::sin(t) + .2 * std::cos(3 * t), std::sin(2 * t) + .1 * std::cos(t));
  });
}

Curve limacon(int m)
{
  return sampled(m, [](double t) { return (1 + 2 * std::cos(t)) * std::polar(1., t); });
}

Curve rose(int m)
{
  return sampled(m, [](double t) {
    return std::complex(.8 * std::cos(t) + 1.2 * std::cos(3 * t) + .1 * std::cos(2 * t),
                        .8 * std::sin(t) + 1.2 * std::sin(3 * t));
  });
}

std::complex<double> edge(const Curve& points, Eigen::Index i)
{
  const Eigen::Vector2d e = points.col((i + 1) % points.cols()) - points.col(i);
  return {e.x(), e.y()};
}

double length_of(const Curve& points)
{
  double length = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) length += std::abs(edge(points, i));
  return length;
}

std::vector<double> angles_of(const Curve& points)
{
  std::vector<double> angles;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    angles.push_back(
        std::arg(edge(points, i) / edge(points, (i + points.cols() - 1) % points.cols())));
  return angles;
}

Eigen::VectorXd curvatures_of(const Curve& points)
{
  const std::vector<double> angles = angles_of(points);
  Eigen::VectorXd kappa(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    kappa[i] = angles[static_cast<std::size_t>(i)] * 2 /
               (std::abs(edge(points, i)) +
                std::abs(edge(points, (i + points.cols() - 1) % points.cols())));
  return kappa;
}

double energy_times_length(const Curve& points)
{
  const std::vector<double> angles = angles_of(points);
  const Eigen::VectorXd kappa = curvatures_of(points);
  double energy = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    energy += kappa[i] * angles[static_cast<std::size_t>(i)];
  return energy * length_of(points);
}

double turns_of(const Curve& points)
{
  double sum = 0;
  for (const double angle : angles_of(points)) sum += angle;
  return sum / (2 * pi);
}

double distortion(const Curve& before, const Curve& after)
{
  double worst = 0;
  for (Eigen::Index i = 0; i < before.cols(); ++i)
    worst = std::max(worst, std::abs(std::abs(edge(after, i)) / std::abs(edge(before, i)) - 1));
  return worst;
}

Curve first_points(const Curve& points, Eigen::Index count)
{
  return points.leftCols(count);
}

}  // namespace cgp_test
