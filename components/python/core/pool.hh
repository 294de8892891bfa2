#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/life.hh"
#include "core/memory.hh"
#include "core/reading.hh"
#include "core/steering.hh"
#include "shared/threads/workers.hh"

namespace pongsim::python {

/// Worlds that are stepped together on several threads, without Python in between: from rows of actions, one for each
/// world, to rows of readings. Worlds are independent, so the results do not depend on the threads.
///
/// First add readings and steerings, the same ones in the same order to each world; then `seal` creates the arrays.
class Pool {
 public:
  Pool(std::vector<std::shared_ptr<Life>> lives, std::size_t threads);

  void addReading(std::size_t world, Reading reading);
  void addSteering(std::size_t world, Steering steering);
  /// Sets the limits of the next number of the action, for all worlds.
  void limitAction(double low, double high) {
    checkOpen();
    actionLimits_.push_back({low, high});
  }
  /// Includes a number from the readings in the observation, with limits, for all worlds.
  void observe(std::size_t column, double low, double high) {
    checkOpen();
    observed_.push_back({column, {low, high}});
  }
  /// Creates the arrays.
  /// Raises ValueError if worlds differ in their readings or steerings.
  void seal();

  /// Runs as many steps as `steps` says, applying the actions of worlds with `commanded` set, and reads.
  /// Raises ValueError for an action that is not finite, any exception raised in a step, and NoReading if a commanded
  /// world has none, because somebody else has reset it.
  void step();
  /// Saves a world's state and its readings, for `restore`.
  void save(std::size_t world);
  /// Restores the worlds with `restored` set to their saved states, and reads. Raises Refused.
  void restore();
  /// @return The name of a reading that a world has not received yet; empty if it has all.
  std::string missing(std::size_t world) const;

  std::size_t count() const { return worlds_.size(); }
  std::size_t actionSize() const { return actionLimits_.size(); }
  std::size_t valueSize() const { return valueSize_; }

  /// Rows of doubles, one for each world: actions, current readings, and the readings before the last step.
  std::shared_ptr<Memory> actions, values, before;
  /// Rows of floats: the observations.
  std::shared_ptr<Memory> observations;
  /// For each world: number of physics steps (64-bit integers), whether it is commanded, whether it is restored
  /// (bytes).
  std::shared_ptr<Memory> steps, commanded, restored;

 private:
  /// One of the worlds.
  class Place final : public Life::Pending {
   public:
    explicit Place(std::shared_ptr<Life> ofWhom) : life(std::move(ofWhom)) {}
    void letGo() override;
    void forget() override;

    std::shared_ptr<Life> life;
    std::vector<Reading> readings;
    std::vector<Steering> steerings;
    std::vector<std::byte> saved;
  };
  struct Limits {
    double low;
    double high;
  };
  struct Observed {
    std::size_t column;
    Limits limits;
  };

  template <class Number>
  static std::span<Number> rowOf(const std::shared_ptr<Memory>& memory, std::size_t row, std::size_t width);
  Place& placeOf(std::size_t world);
  /// Raises ValueError if the arrays have been created already.
  void checkOpen() const {
    if (isSealed_) throw py::value_error("the pool is sealed");
  }
  /// Calls `work` for each world on the threads, without the GIL, and raises an exception thrown by one.
  shared::Workers& startedWorkers();
  template <class Work>
  void forAll(const char* what, Work work);
  void raiseThrown(const std::vector<std::exception_ptr>& thrown) const;
  void checkActions() const;
  void advance(std::size_t world, Simulation& simulation);
  void putBack(std::size_t world, Simulation& simulation);
  void read(std::size_t world, bool isFirst);

  std::vector<std::shared_ptr<Place>> worlds_;
  std::vector<std::shared_ptr<Life>> lives_;
  std::size_t threads_;
  /// Started with the first step, so that the process may be forked until then.
  std::optional<shared::Workers> workers_;
  std::vector<Limits> actionLimits_;
  std::vector<Observed> observed_;
  std::size_t valueSize_ = 0;
  bool isSealed_ = false;
};

/// Binds the pool. Call after binding the simulation, whose Python types it uses.
void bindPool(py::module_& module);

}  // namespace pongsim::python
