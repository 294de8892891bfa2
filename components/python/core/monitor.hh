#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "core/life.hh"
#include "pongsim/expect/monitor.hh"
#include "pongsim/lockstep_run.hh"

namespace pongsim::python {

/// A monitor of a simulation, for pongsim.testing, until the simulation ends.
class PyMonitor final : public Life::Pending {
 public:
  /// @param lockstep None, or a dict: topics ("TOPIC:EVERY:COUNT"), start, timeout [s], late ("end", "continue").
  static std::shared_ptr<PyMonitor> open(const std::shared_ptr<Life>& life, const py::object& lockstep);
  void letGo() override {
    lockstep_.reset();
    monitor_.reset();
  }

  /// @param expectation A dict like the members of `Expectation`; times in seconds. Raises ValueError.
  std::size_t add(const py::dict& expectation);
  /// Makes steps until the time [s] or until an expectation is decided. Raises like `Simulation.step`, and RuntimeError
  /// where the lockstep ends the run.
  /// @param between None, or called some times a second, also while the lockstep waits; what it raises ends the steps.
  /// @return Whether one was decided.
  bool runUntil(double time, const py::object& between);
  void finish();
  std::size_t decided() { return use().decided(); }
  /// @return state, time, expected, seen, field, times, values.
  py::tuple verdict(std::size_t number);

 private:
  Monitor& use() const;

  std::weak_ptr<Life> life_;
  std::unique_ptr<Monitor> monitor_;
  std::unique_ptr<LockstepRun> lockstep_;
};

/// Binds the monitor, and what else runs of scenarios need.
void bindMonitor(py::module_& module);

}  // namespace pongsim::python
