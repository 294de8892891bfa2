#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/interpreter.hh"
#include "pongsim/node.hh"
#include "pongsim/simulation.hh"

namespace pongsim {
class RayScene;
}

namespace pongsim::python {

class StateVector;
class Stream;

namespace py = pybind11;

/// A Python object that C++ calls. The garbage collector reaches it through the simulation that it belongs to
/// (`Life::traverse`), so a callback that refers to its own simulation keeps nothing alive.
class Kept {
 public:
  explicit Kept(py::object object) : object_(object.release().ptr()) {}
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;
  /// The GIL must be held.
  ~Kept() { Py_CLEAR(object_); }
  PyObject* ptr() const { return object_; }
  py::object get() const { return py::reinterpret_borrow<py::object>(object_); }

 private:
  PyObject* object_;
};

/// Ends a subscription. This waits for a dispatch on another thread to finish, which may need the GIL.
inline void end(Subscription& subscription) {
  if (!subscription) return;
  const interpreter::Released released;
  subscription = Subscription();
}

/// One publisher for each topic and type that has been published on.
using Publishers = std::map<std::pair<std::string, std::string>, Publisher>;

/// The state shared by all Python objects of one simulation. It outlives the simulation, so that they can report that
/// it is gone. Its functions require the GIL, which guards everything except what a running step does.
class Life {
 public:
  /// Notified when the simulation ends, to release what depends on it.
  class Pending {
   public:
    virtual ~Pending() = default;
    virtual void letGo() = 0;
    /// Called when the world is reset or a state is restored: forgets what was received before.
    virtual void forget() {}
  };

  /// @param transport Null: the simulation's own.
  Life(std::unique_ptr<Transport> transport, std::unique_ptr<Simulation> simulation)
      : transport_(std::move(transport)), simulation_(std::move(simulation)) {}
  ~Life() { release(); }

  /// @return The simulation, for reading or commanding, also during a step.
  /// @throws Gone if it is closed, Busy if another thread is stepping it.
  Simulation& use() const;
  /// @return The simulation, for changes between steps; `what` names the change in the message.
  Simulation& edit(const char* what) const;
  /// Whether it communicates with other processes.
  bool isOnNetwork() const { return transport_ != nullptr; }
  bool isClosed() const { return simulation_ == nullptr; }
  bool isStepping() const { return stepper_ != 0; }

  /// Lets the systems complete what they write, and ends the simulation; any access raises Gone from then on.
  /// Raises SystemFailed if a file is not complete; the simulation has ended nevertheless.
  void close();
  /// Ends the simulation without reporting whether its files are complete.
  void release();

  /// Keeps an object for C++ to call.
  std::shared_ptr<Kept> keep(py::object object);
  /// Reports what is kept to the garbage collector.
  int traverse(visitproc visit, void* arg) const;

  /// Runs `work`, which takes steps, with the GIL released. Raises what a callback raised meanwhile.
  template <class Work>
  void stepping(Work work);

  /// Like `stepping`, for several simulations. `work` steps them on threads of its own, which must call a simulation's
  /// `takeOver` before they step it. If callbacks of several raised exceptions, the first simulation's is raised.
  template <class Work>
  static void steppingAll(std::span<const std::shared_ptr<Life>> lives, Work work);
  /// Makes the calling thread the one that steps it, within `steppingAll`. Without the GIL.
  void takeOver() { stepper_ = PyThread_get_thread_ident(); }

  /// Raises what a step or the end has reported: SystemFailed, with the exception of the Python system that failed.
  [[noreturn]] void raiseFailure(const char* what) const;

  /// Whether the steps should end because a callback raised an exception or a signal arrived. Called in a step, without
  /// the GIL.
  bool mustStop();

  /// Records an exception from a callback, to be raised by the step that called it.
  void noteError(py::error_already_set& error);
  /// Records an exception from a system, as the cause of what a strict step raises.
  void noteFailure(py::object exception) { failure_ = std::make_shared<Kept>(std::move(exception)); }
  py::object failure() const { return failure_ ? failure_->get() : py::none(); }

  /// Notifies it when the simulation ends, if it still exists.
  void tell(const std::weak_ptr<Pending>& pending);
  /// Like `tell`, and keeps it until it is dropped.
  void hold(std::shared_ptr<Pending> pending) { held_.push_back(std::move(pending)); }
  void drop(const Pending& pending) {
    std::erase_if(held_, [&](const std::shared_ptr<Pending>& each) { return each.get() == &pending; });
  }

  /// Makes all that has received something forget it, because it is of the time before a reset or a restored state.
  void forgetPast();

  /// Publishers of the simulation, destroyed before it.
  Publishers publishers;
  /// The readings that are switched on, by the sensor's id and their kind. All objects for a sensor share them.
  std::map<std::pair<std::uint64_t, std::string>, std::shared_ptr<Stream>> streams;
  /// Made on first use.
  std::shared_ptr<StateVector> stateVector;
  std::shared_ptr<RayScene> rayScene;

 private:
  void checkThread() const;
  void begin();
  void end();
  Outcome<void> finish();
  void raiseNoted();
  void forgetNoted();

  // before the simulation, which uses it
  std::unique_ptr<Transport> transport_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<std::weak_ptr<Kept>> kept_;
  std::size_t sweepAt_ = 64;
  /// The exception of the Python system that failed last.
  std::shared_ptr<Kept> failure_;
  /// Python's id of the thread that takes steps, or 0.
  std::atomic<unsigned long> stepper_ = 0;
  std::int64_t nextLook_ = 0;
  bool hasError_ = false;
  std::shared_ptr<Kept> error_;

  std::vector<std::weak_ptr<Pending>> pending_;
  std::vector<std::shared_ptr<Pending>> held_;
};

template <class Work>
void Life::stepping(Work work) {
  begin();
  try {
    const interpreter::Released released;
    work();
  } catch (...) {
    end();
    throw;
  }
  end();
  if (hasError_) raiseNoted();
}

template <class Work>
void Life::steppingAll(std::span<const std::shared_ptr<Life>> lives, Work work) {
  const auto endAll = [&] {
    for (const auto& life : lives) life->end();
  };
  for (const auto& life : lives) life->begin();
  try {
    const interpreter::Released released;
    work();
  } catch (...) {
    endAll();
    throw;
  }
  endAll();
  for (const auto& life : lives) {
    if (!life->hasError_) continue;
    for (const auto& other : lives) {
      if (other != life) other->forgetNoted();
    }
    life->raiseNoted();
  }
}

/// A handle of the simulation in Python.
template <class Inner>
struct Handle {
  std::shared_ptr<Life> life;
  Inner inner;

  /// @throws Gone, Busy like `Life::use`.
  Inner& use() {
    life->use();
    return inner;
  }
  Inner& edit(const char* what) {
    life->edit(what);
    return inner;
  }
};

}  // namespace pongsim::python
