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

#include "pongsim/node.hh"
#include "pongsim/simulation.hh"

namespace pongsim::python {

namespace py = pybind11;

/// A Python object that C++ calls. The garbage collector sees it by the simulation that it belongs to
/// (`Life::traverse`), so that a callback that knows its own simulation keeps nothing alive.
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

/// Ends a subscription, for which a dispatch on another thread must end first, which may want the GIL.
inline void end(Subscription& subscription) {
  if (!subscription) return;
  const py::gil_scoped_release released;
  subscription = Subscription();
}

/// What is said on a topic: a publisher for each topic and type that was published on.
using Publishers = std::map<std::pair<std::string, std::string>, Publisher>;

/// What all Python objects of one simulation share; it outlives the simulation, so that they can say that it is gone.
/// Its functions want the GIL, with which all of it is guarded but for what a step in progress does.
class Life {
 public:
  /// Told when the simulation ends: what holds on to it lets go.
  class Pending {
   public:
    virtual ~Pending() = default;
    virtual void letGo() = 0;
  };

  /// @param transport Null: the simulation's own.
  Life(std::unique_ptr<Transport> transport, std::unique_ptr<Simulation> simulation)
      : transport_(std::move(transport)), simulation_(std::move(simulation)) {}
  ~Life() { close(); }

  /// @return The simulation, to look at or to command: also within a step.
  /// @throws Gone where it is closed, Busy where another thread steps it.
  Simulation& use() const;
  /// @return The simulation, to change between two steps: `what` that is, for the message.
  Simulation& edit(const char* what) const;
  /// Whether it speaks with other processes.
  bool isOnNetwork() const { return transport_ != nullptr; }
  bool isClosed() const { return simulation_ == nullptr; }
  bool isStepping() const { return stepper_ != 0; }

  /// Ends the simulation; whatever leads to it raises Gone from then on.
  void close();

  /// Keeps an object for C++ to call.
  std::shared_ptr<Kept> keep(py::object object);
  /// Shows the collector what is kept.
  int traverse(visitproc visit, void* arg) const;

  /// Runs `work`, which takes steps, with the GIL released. Raises what a callback has raised meanwhile.
  template <class Work>
  void stepping(Work work);

  /// As `stepping`, for several simulations of which `work` takes steps on threads of its own, each of which says
  /// `takeOver` to a simulation before it steps it. What callbacks of several have raised counts of the first one.
  template <class Work>
  static void steppingAll(std::span<const std::shared_ptr<Life>> lives, Work work);
  /// The calling thread steps it from now on, within `steppingAll`. Without the GIL.
  void takeOver() { stepper_ = PyThread_get_thread_ident(); }

  /// Raises what a step has thrown: SystemFailed, with the exception of the system in Python that has failed.
  [[noreturn]] void raiseFailure(const char* what) const;

  /// Whether the steps are to end, since a callback has raised something or a signal has come. Without the GIL, in a
  /// step.
  bool mustStop();

  /// Keeps what a callback has raised, to be raised by the step in which it was called.
  void noteError(py::error_already_set& error);
  /// Keeps what a system has raised, as the cause of what a strict step raises.
  void noteFailure(py::object exception) { failure_ = std::make_shared<Kept>(std::move(exception)); }
  py::object failure() const { return failure_ ? failure_->get() : py::none(); }

  /// Lets it know when the simulation ends, if it is there then.
  void tell(const std::weak_ptr<Pending>& pending);
  /// As `tell`, and keeps it until it is dropped.
  void hold(std::shared_ptr<Pending> pending) { held_.push_back(std::move(pending)); }
  void drop(const Pending& pending) {
    std::erase_if(held_, [&](const std::shared_ptr<Pending>& each) { return each.get() == &pending; });
  }

  /// Of the simulation; they go before it.
  Publishers publishers;

 private:
  void checkThread() const;
  void begin();
  void end();
  void raiseNoted();
  void forgetNoted();

  // the simulation, which speaks by it, goes first
  std::unique_ptr<Transport> transport_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<std::weak_ptr<Kept>> kept_;
  std::size_t sweepAt_ = 64;
  /// What must go before the simulation does.
  std::shared_ptr<Kept> failure_;
  /// The thread that takes steps, as Python numbers it, or 0.
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
  PyThreadState* state = PyEval_SaveThread();
  try {
    work();
  } catch (...) {
    PyEval_RestoreThread(state);
    end();
    throw;
  }
  PyEval_RestoreThread(state);
  end();
  if (hasError_) raiseNoted();
}

template <class Work>
void Life::steppingAll(std::span<const std::shared_ptr<Life>> lives, Work work) {
  const auto endAll = [&] {
    for (const auto& life : lives) life->end();
  };
  for (const auto& life : lives) life->begin();
  PyThreadState* state = PyEval_SaveThread();
  try {
    work();
  } catch (...) {
    PyEval_RestoreThread(state);
    endAll();
    throw;
  }
  PyEval_RestoreThread(state);
  endAll();
  for (const auto& life : lives) {
    if (!life->hasError_) continue;
    for (const auto& other : lives) {
      if (other != life) other->forgetNoted();
    }
    life->raiseNoted();
  }
}

/// A handle of the simulation's, as Python has it.
template <class Inner>
struct Handle {
  std::shared_ptr<Life> life;
  Inner inner;

  /// @throws Gone, Busy as `Life::use`.
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
