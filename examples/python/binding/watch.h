// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <pybind11/pybind11.h>

#include <atomic>
#include <string>
#include <utility>

namespace conformal_python {

namespace py = pybind11;
namespace CGP = Conformal_geometry_processing;

/// Computes without the lock of the interpreter, so that other threads of Python go on.
template <class Compute>
auto without_lock(Compute compute)
{
  const py::gil_scoped_release release;
  return compute();
}

/// Ctrl-C becomes an exception here, between two iterations; needs the lock.
inline void raise_signals()
{
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

/// whether a callback wants more: all but a false result, for most callbacks return nothing
inline bool wants_more(const py::object& answer)
{
  return answer.is_none() || answer.cast<py::bool_>();
}

/// The `go_further` of eigensolvers: asks for signals, then a callback, which may be None. What it
/// raises ends the computation.
class Watch {
 public:
  explicit Watch(py::object callback) : m_callback(std::move(callback)) {}

  bool operator()(const CGP::Eigensolver_progress& p) const
  {
    const py::gil_scoped_acquire lock;
    raise_signals();
    return m_callback.is_none() || wants_more(m_callback(p.iteration, p.value, p.estimate));
  }

 private:
  py::object m_callback;
};

/// Keeps a second thread, or a callback, from computing with an object that is computing.
class Turn {
 public:
  Turn(std::atomic_flag& flag, const std::string& function) : m_flag(flag)
  {
    if (m_flag.test_and_set())
      throw CGP::Precondition_error(function, "the object is computing already");
  }
  ~Turn() { m_flag.clear(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  std::atomic_flag& m_flag;
};

}  // namespace conformal_python
