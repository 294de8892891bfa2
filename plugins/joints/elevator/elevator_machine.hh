#pragma once

#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Decides what an elevator does: it goes to a floor, opens that floor's door, waits, closes it, and goes on to where
/// it was called meanwhile.
class ElevatorMachine {
 public:
  enum class Phase { kIdle, kMoving, kOpening, kWaiting, kClosing };

  /// What it moves, and what it sees of that.
  struct Doings {
    std::function<void(int floor)> sendCabin;
    std::function<bool(int floor)> isCabinAt;
    std::function<void(int floor, bool open)> sendDoor;
    std::function<bool(int floor, bool open)> isDoor;
  };

  /// @param wait How long a door stays open.
  ElevatorMachine(Time wait, Doings doings) : wait_(wait), doings_(std::move(doings)) {}

  Phase phase() const { return phase_; }

  /// Takes a call. Where the elevator is moving or its door is open it is heeded once the door closes.
  /// @param target A floor that there is.
  void call(int target);

  /// Goes on.
  /// @param floor That the cabin is nearest to.
  /// @param isBlocked Whether something stands in the door of that floor. A door that is open stays so until it has
  /// been free for as long as it stays open.
  void update(Time now, int floor, bool isBlocked);

  void reset();
  void transfer(StateArchive& archive);

 private:
  void enqueue(int target);
  void enterMoving();
  void enterDoor(bool opens);

  Time wait_;
  Doings doings_;
  Phase phase_ = Phase::kIdle;
  Time now_{0};
  int floor_ = 0;
  /// Floors to go to, in this order.
  std::deque<int> targets_;
  /// Calls that are not heeded yet.
  std::vector<int> calls_;
  /// Of the door that moves or is open.
  int doorFloor_ = 0;
  Time timeout_{0};
  bool wasBlocked_ = false;
};

}  // namespace pongsim
