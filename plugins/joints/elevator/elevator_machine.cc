#include "elevator_machine.hh"

#include <algorithm>

namespace pongsim {

void ElevatorMachine::call(int target) {
  if (phase_ == Phase::kClosing) {
    enqueue(target);
  } else if (phase_ != Phase::kIdle) {
    calls_.push_back(target);
  } else if (target == floor_) {
    enterDoor(true);
  } else {
    enqueue(target);
    enterMoving();
  }
}

void ElevatorMachine::update(Time now, int floor, bool isBlocked) {
  now_ = now;
  floor_ = floor;
  if (phase_ == Phase::kWaiting) {
    if (!isBlocked && wasBlocked_) timeout_ = now + wait_;
    wasBlocked_ = isBlocked;
    if (!isBlocked && now >= timeout_) enterDoor(false);
  }
  if (phase_ == Phase::kOpening && doings_.isDoor(doorFloor_, true)) {
    phase_ = Phase::kWaiting;
    timeout_ = now + wait_;
    wasBlocked_ = false;
  } else if (phase_ == Phase::kClosing && doings_.isDoor(doorFloor_, false)) {
    if (targets_.empty()) {
      phase_ = Phase::kIdle;
    } else {
      enterMoving();
    }
  }
  if (phase_ == Phase::kMoving && doings_.isCabinAt(targets_.front())) {
    targets_.pop_front();
    enterDoor(true);
  }
}

void ElevatorMachine::enqueue(int target) {
  if (std::ranges::find(targets_, target) != targets_.end()) return;
  // served in passing, because it is on the way
  int from = floor_;
  for (auto next = targets_.begin(); next != targets_.end(); ++next) {
    const auto [lower, upper] = std::minmax(from, *next);
    if (target >= lower && target < upper) {
      targets_.insert(next, target);
      return;
    }
    from = *next;
  }
  targets_.push_back(target);
}

void ElevatorMachine::enterMoving() {
  phase_ = Phase::kMoving;
  doings_.sendCabin(targets_.front());
}

void ElevatorMachine::enterDoor(bool opens) {
  phase_ = opens ? Phase::kOpening : Phase::kClosing;
  doorFloor_ = floor_;
  doings_.sendDoor(doorFloor_, opens);
  if (opens) return;
  for (const int target : calls_) enqueue(target);
  calls_.clear();
}

void ElevatorMachine::reset() {
  phase_ = Phase::kIdle;
  now_ = timeout_ = Time(0);
  floor_ = doorFloor_ = 0;
  targets_.clear();
  calls_.clear();
  wasBlocked_ = false;
}

void ElevatorMachine::transfer(StateArchive& archive, int floors) {
  archive(phase_, Phase::kClosing);
  archive(now_);
  archive(floor_);
  archive(targets_);
  archive(calls_);
  archive(doorFloor_);
  archive(timeout_);
  archive(wasBlocked_);
  const auto isFloor = [floors](int floor) { return floor >= 0 && floor < floors; };
  archive.check(isFloor(floor_) && isFloor(doorFloor_) && std::ranges::all_of(targets_, isFloor) &&
                std::ranges::all_of(calls_, isFloor) && (phase_ != Phase::kMoving || !targets_.empty()));
}

}  // namespace pongsim
