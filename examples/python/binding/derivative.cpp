// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "binding.h"
#include "options.h"
#include "watch.h"

#include <Conformal_geometry_processing/spin/Spin_derivative.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <atomic>
#include <optional>
#include <utility>

namespace conformal_python {
namespace {

using Vectors = CGP::Block<CGP::Quaternion<double>>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Array to_array(const Eigen::MatrixXd& m)
{
  Array a(std::vector<py::ssize_t>{m.rows(), m.cols()});
  Eigen::Map<Rows>(a.mutable_data(), m.rows(), m.cols()) = m;
  return a;
}

/// 4n x k numbers as n x k quaternions, and back
Vectors to_spins(const Eigen::MatrixXd& m)
{
  Vectors v(m.rows() / 4, m.cols());
  Eigen::Map<Eigen::MatrixXd>(&v.data()->w, m.rows(), m.cols()) = m;
  return v;
}

Eigen::MatrixXd to_numbers(const Vectors& v)
{
  return Eigen::Map<const Eigen::MatrixXd>(&v.data()->w, 4 * v.rows(), v.cols());
}

/// the derivative of the transformation by a rho, which is applied as it is; spins, and log scales
/// up to a constant, are those of constant mean square, positions those of constant area
class Derivative {
 public:
  Derivative(const Array& V, const Indices& F, const Array& rho, const std::string& on,
             const py::dict& options, const py::dict& dirac)
      : m_mesh(mesh_view(V, F, function)),
        m_transformation(m_mesh, transformation_options(options, m_mesh, function), function),
        m_rho(potential(rho, on, m_mesh, function))
  {
    const CGP::Dirac_options own = dirac_options(dirac, function);
    const Watch watch{py::none()};
    without_lock([&] { linearize(own, watch); });
  }

  Array spins(const Array& changes) const
  {
    return computed(changes, m_rho.values.size(), [&](const Eigen::MatrixXd& x) {
      return to_numbers(m_spins->apply(x * unit()));
    });
  }

  Array spins_transpose(const Array& y) const
  {
    return computed(y, 4 * vertices(), [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd {
      return unit() * m_spins->apply_transpose(to_spins(x));
    });
  }

  Array log_scales(const Array& changes) const
  {
    return computed(changes, m_rho.values.size(), [&](const Eigen::MatrixXd& x) {
      return CGP::internal::log_scale_change(m_lambda, m_spins->apply(x * unit()));
    });
  }

  Array log_scales_transpose(const Array& y) const
  {
    return computed(y, vertices(), [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd {
      return unit() * m_spins->apply_transpose(CGP::internal::log_scale_gradient(m_lambda, x));
    });
  }

  Array positions(const Array& changes) const
  {
    return computed(changes, m_rho.values.size(), [&](const Eigen::MatrixXd& x) {
      const Vectors spins = m_spins->apply(x * unit());
      Eigen::MatrixXd moved(3 * vertices(), x.cols());
      for (Eigen::Index k = 0; k < x.cols(); ++k)
        moved.col(k) = unit() * m_positions->apply(spins.col(k)).reshaped();
      return moved;
    });
  }

  Array positions_transpose(const Array& y) const
  {
    return computed(y, 3 * vertices(), [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd {
      Vectors q(vertices(), x.cols());
      for (Eigen::Index k = 0; k < x.cols(); ++k)
        q.col(k) = m_positions->apply_transpose(x.col(k).reshaped(3, vertices()));
      return unit() * unit() * m_spins->apply_transpose(q);
    });
  }

  Array eigenvalue(const Array& changes) const
  {
    return computed(changes, m_rho.values.size(), [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd {
      return m_spins->gamma_change(x);
    });
  }

  /// M_V of the spins, in the frame: only ratios matter
  Array masses() const { return to_array(m_transformation.system().areas()); }

  Eigen::Index inputs() const { return m_rho.values.size(); }

 private:
  void linearize(const CGP::Dirac_options& options, const Watch& watch)
  {
    m_transformation.dirac() = options;
    const CGP::Spin_result found = m_transformation.step(m_rho, std::cref(watch));
    if (!found.report.converged)
      throw CGP::Solver_error(function, "the Dirac equation is not solved");
    const auto& system = m_transformation.system();
    CGP::Curvature_potential potential = m_rho;
    if (system.is_closed()) potential.values.array() += found.report.eigenvalue;
    potential.values *= unit();
    m_lambda = found.lambda;
    const double tolerance = 1e-12;
    m_spins.emplace(system, std::move(potential), m_lambda, tolerance);
    const CGP::internal::Framed_surface& domain = m_transformation.domain();
    m_positions.emplace(system, m_transformation.reconstruction(), domain.measured(), m_lambda,
                        domain.frame().to_frame(found.positions));
  }

  template <class Compute>
  Array computed(const Array& x, Eigen::Index rows, Compute compute) const
  {
    const Turn turn(m_is_computing, function);
    const Eigen::MatrixXd given = columns(x, rows, function);
    return to_array(without_lock([&]() -> Eigen::MatrixXd { return compute(given); }));
  }

  double unit() const { return m_transformation.domain().unit(); }
  Eigen::Index vertices() const { return m_mesh.size_of_vertices(); }

  static constexpr const char* function = "Spin_derivative";
  CGP::Mesh_view m_mesh;
  CGP::Spin_transformation m_transformation;
  CGP::Curvature_potential m_rho;
  Spins m_lambda;
  std::optional<CGP::internal::Spin_derivative> m_spins;
  std::optional<CGP::internal::Position_derivative> m_positions;
  mutable std::atomic_flag m_is_computing = ATOMIC_FLAG_INIT;
};

}  // namespace

void add_derivative(py::module_& m)
{
  using py::arg;
  py::class_<Derivative>(m, "Derivative")
      .def(py::init<const Array&, const Indices&, const Array&, const std::string&, const py::dict&,
                    const py::dict&>(),
           arg("V"), arg("F"), arg("rho"), arg("on"), arg("options"), arg("dirac"))
      .def("spins", &Derivative::spins, arg("x"))
      .def("spins_transpose", &Derivative::spins_transpose, arg("y"))
      .def("log_scales", &Derivative::log_scales, arg("x"))
      .def("log_scales_transpose", &Derivative::log_scales_transpose, arg("y"))
      .def("positions", &Derivative::positions, arg("x"))
      .def("positions_transpose", &Derivative::positions_transpose, arg("y"))
      .def("eigenvalue", &Derivative::eigenvalue, arg("x"))
      .def("masses", &Derivative::masses)
      .def("inputs", &Derivative::inputs);
}

}  // namespace conformal_python
