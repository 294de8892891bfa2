#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "core/life.hh"
#include "pongsim/expect/monitor.hh"

namespace pongsim::python {

/// A monitor of a simulation, for pongsim.testing, until the simulation ends.
class PyMonitor final : public Life::Pending {
 public:
  static std::shared_ptr<PyMonitor> open(const std::shared_ptr<Life>& life);
  void letGo() override { monitor_.reset(); }

  /// @param expectation A dict like the members of `Expectation`; times in seconds. Raises ValueError.
  std::size_t add(const py::dict& expectation);
  /// Makes steps until the time [s] or until an expectation is decided. Raises like `Simulation.step`.
  /// @return Whether one was decided.
  bool runUntil(double time);
  void finish();
  std::size_t decided() { return use().decided(); }
  /// @return state, time, expected, seen, field, times, values.
  py::tuple verdict(std::size_t number);

 private:
  Monitor& use() const;

  std::weak_ptr<Life> life_;
  std::unique_ptr<Monitor> monitor_;
};

/// Binds the monitor, and what else runs of scenarios need.
void bindMonitor(py::module_& module);

}  // namespace pongsim::python
