#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/crew.hh"
#include "core/life.hh"
#include "core/memory.hh"
#include "core/reading.hh"
#include "core/steering.hh"

namespace pongsim::python {

/// Worlds that are stepped together, on several threads: from rows of an action each to rows of what was read of each,
/// with nothing of Python's between. What a world does is its own, so that the results do not depend on the threads.
///
/// First readings and steerings are added, to each world the same ones in the same order; then `seal` makes the arrays.
class Pool {
 public:
  Pool(std::vector<std::shared_ptr<Life>> lives, std::size_t threads);

  void addReading(std::size_t world, Reading reading);
  void addSteering(std::size_t world, Steering steering);
  /// Limits what an action's number may say; in the order of the numbers, for all worlds.
  void limitAction(double low, double high) {
    checkOpen();
    actionLimits_.push_back({low, high});
  }
  /// Takes a number that was read into what is observed, within limits; for all worlds.
  void observe(std::size_t column, double low, double high) {
    checkOpen();
    observed_.push_back({column, {low, high}});
  }
  /// Makes the arrays.
  /// Raises ValueError where worlds differ in what is read or steered.
  void seal();

  /// Takes the steps that `steps` says, with the actions where `commanded` says so, and reads.
  /// Raises ValueError for an action that is not finite, and what steps raise.
  void step();
  /// Keeps the state of a world, with what was read of it, for `restore`.
  void save(std::size_t world);
  /// Puts the worlds for which `restored` is set back to where they were saved, and reads. Raises Refused.
  void restore();
  /// Hands over what waits in a world and forgets what was heard of it: before it is set back to its start.
  void forget(std::size_t world);
  /// @return What has not been heard in a world yet; empty where all has.
  std::string missing(std::size_t world) const;

  std::size_t count() const { return worlds_.size(); }
  std::size_t actionSize() const { return actionLimits_.size(); }
  std::size_t valueSize() const { return valueSize_; }

  /// Rows of doubles: what each world is told, is to be read now, and was read before the last step.
  std::shared_ptr<Memory> actions, values, before;
  /// Rows of floats: what is observed.
  std::shared_ptr<Memory> observations;
  /// Of each world: physics steps to take (64-bit integers), whether it is commanded, whether it is restored (bytes).
  std::shared_ptr<Memory> steps, commanded, restored;

 private:
  /// One of them.
  class Place final : public Life::Pending {
   public:
    explicit Place(std::shared_ptr<Life> ofWhom) : life(std::move(ofWhom)) {}
    void letGo() override;

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
  /// Raises ValueError where the arrays are made already.
  void checkOpen() const {
    if (isSealed_) throw py::value_error("the pool is sealed");
  }
  /// Calls `work` for each world on the crew's threads, without the GIL, and raises what one throws.
  template <class Work>
  void forAll(const char* what, Work work);
  void raiseThrown(const std::vector<std::exception_ptr>& thrown) const;
  void checkActions() const;
  void advance(std::size_t world, Simulation& simulation);
  void putBack(std::size_t world, Simulation& simulation);
  void read(std::size_t world, bool isFirst);

  std::vector<std::shared_ptr<Place>> worlds_;
  std::vector<std::shared_ptr<Life>> lives_;
  Crew crew_;
  std::vector<Limits> actionLimits_;
  std::vector<Observed> observed_;
  std::size_t valueSize_ = 0;
  bool isSealed_ = false;
};

/// Adds the pool. After the simulation, whose Python objects it takes.
void bindPool(py::module_& module);

}  // namespace pongsim::python
