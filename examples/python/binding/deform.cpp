// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "binding.h"
#include "transformation.h"

#include <Conformal_geometry_processing/spin/Conformal_deformation.h>

#include <Eigen/Core>

#include <atomic>
#include <memory>
#include <utility>
#include <vector>

namespace conformal_python {
namespace {

using CGP::internal::Control_point;

/// `Conformal_deformation` on arrays, used by one thread at a time
class Deformation {
 public:
  Deformation(const Array& V, const Indices& F, const py::dict& options, std::string function)
      : m_function(std::move(function)), m_mesh(mesh_view(V, F, m_function))
  {
    CGP::internal::Conformal_deformation_options own;
    own.surface = transformation_options(options, m_mesh, m_function);
    take(options, "position_weight", own.position_weight);
    own.region = take_numbers(options, "vertex_region", m_function);
    m_deformation = without_lock([&] {
      return std::make_unique<CGP::internal::Conformal_deformation>(m_mesh, own, m_function);
    });
  }

  /// \param targets k x 3 \returns (positions, spins, report, rho)
  py::tuple deform(const std::vector<int>& vertices, const Array& targets, const py::dict& bounds,
                   const py::object& callback)
  {
    const std::vector<Control_point> points = control_points(vertices, targets);
    CGP::Spin_report::Limits limits = conformal_python::limits(bounds);
    if (!bounds.contains("realised_share")) limits.realised_share = 1;
    const Watch watch(callback);
    const Turn turn(m_is_computing, m_function);
    CGP::Spin_result result =
        without_lock([&] { return m_deformation->deform(points, std::cref(watch)); });
    result.report.limits = limits;
    const Eigen::VectorXd& rho = m_deformation->potential().values;
    return py::make_tuple(to_rows(result.positions), to_rows(result.lambda), as_dict(result.report),
                          Array(rho.size(), rho.data()));
  }

 private:
  std::vector<Control_point> control_points(const std::vector<int>& vertices,
                                            const Array& targets) const
  {
    const CGP::Points to =
        vertex_points(targets, static_cast<Eigen::Index>(vertices.size()), m_function, "targets");
    std::vector<Control_point> points;
    for (std::size_t k = 0; k < vertices.size(); ++k)
      points.push_back(
          CGP::internal::control_point(vertices[k], to.col(static_cast<Eigen::Index>(k))));
    return points;
  }

  std::string m_function;
  CGP::Mesh_view m_mesh;
  std::unique_ptr<CGP::internal::Conformal_deformation> m_deformation;
  std::atomic_flag m_is_computing = ATOMIC_FLAG_INIT;
};

}  // namespace

void add_deform(py::module_& m)
{
  using py::arg;
  py::class_<Deformation>(m, "Deformation")
      .def(py::init<const Array&, const Indices&, const py::dict&, std::string>(), arg("V"),
           arg("F"), arg("options"), arg("function"))
      .def("deform", &Deformation::deform, arg("vertices"), arg("targets"), arg("limits"),
           arg("callback"));
}

}  // namespace conformal_python
