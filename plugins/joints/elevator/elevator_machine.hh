#pragma once

#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "pongsim/state/state_archive.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// The state machine of an elevator: it moves to a floor, opens that floor's door, waits, closes it, and moves to the
/// floors called meanwhile.
class ElevatorMachine {
 public:
  enum class Phase { kIdle, kMoving, kOpening, kWaiting, kClosing };

  /// Commands and sensors of the cabin and the doors.
  struct Doings {
    std::function<void(int floor)> sendCabin;
    std::function<bool(int floor)> isCabinAt;
    std::function<void(int floor, bool open)> sendDoor;
    std::function<bool(int floor, bool open)> isDoor;
  };

  /// @param wait How long a door stays open.
  ElevatorMachine(Time wait, Doings doings) : wait_(wait), doings_(std::move(doings)) {}

  Phase phase() const { return phase_; }

  /// Adds a call. While the elevator moves or its door is open, it waits until the door closes.
  /// @param target An existing floor.
  void call(int target);

  /// Advances to `now`.
  /// @param floor Nearest to the cabin.
  /// @param isBlocked Whether something blocks the door of that floor. An open door stays open until it has been free
  /// for the waiting time.
  void update(Time now, int floor, bool isBlocked);

  void reset();
  /// @param floors The number of floors.
  void transfer(StateArchive& archive, int floors);

 private:
  void enqueue(int target);
  void enterMoving();
  void enterDoor(bool opens);

  Time wait_;
  Doings doings_;
  Phase phase_ = Phase::kIdle;
  Time now_{0};
  int floor_ = 0;
  /// Floors to visit, in this order.
  std::deque<int> targets_;
  /// Calls that are still waiting.
  std::vector<int> calls_;
  /// Floor of the door that moves or is open.
  int doorFloor_ = 0;
  Time timeout_{0};
  bool wasBlocked_ = false;
};

}  // namespace pongsim
