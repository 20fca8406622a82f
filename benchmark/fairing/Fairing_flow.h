// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <utility>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// a fairing method with its time step: what all of them have in common
class Fairing_flow {
 public:
  virtual ~Fairing_flow() = default;

  /// \brief moves the surface by one time step.
  /// \returns false, and leaves the surface, if the flow has arrived
  /// \throw Solver_error if a linear system cannot be solved
  virtual bool step() = 0;

  virtual const CGP::Mesh_view& mesh() const = 0;

  /// Replaces the surface by a moved or scaled one, from which the flow continues
  virtual void set_positions(CGP::Points positions) = 0;
};

/// A method that moves the vertices of its own mesh
class Flow_of_positions : public Fairing_flow {
 public:
  Flow_of_positions(const CGP::Mesh_view& mesh, double time_step)
      : m_mesh(mesh), m_time_step(time_step)
  {}

  const CGP::Mesh_view& mesh() const override { return m_mesh; }
  void set_positions(CGP::Points positions) override { m_mesh.set_positions(std::move(positions)); }

 protected:
  double time_step() const { return m_time_step; }

 private:
  CGP::Mesh_view m_mesh;
  double m_time_step;
};

}  // namespace cgp_benchmark
