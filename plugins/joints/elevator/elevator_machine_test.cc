#include "elevator_machine.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pongsim::elevator_machine_test {
namespace {

using Phase = ElevatorMachine::Phase;
using Orders = std::vector<std::string>;

constexpr int kFloors = 4;

/// An elevator whose cabin and doors are where they are told to be when the test says so.
class ElevatorMachineTest : public testing::Test {
 protected:
  ElevatorMachine make() {
    return ElevatorMachine(
        std::chrono::seconds(5),
        {[this](int floor) { order("cabin " + std::to_string(floor)); }, [this](int) { return cabinIsThere_; },
         [this](int floor, bool open) { order((open ? "open " : "close ") + std::to_string(floor)); },
         [this](int, bool) { return doorIsThere_; }});
  }
  void order(const std::string& what) { orders_.push_back(what); }
  void update(int floor, bool isBlocked = false) {
    now_ += std::chrono::seconds(1);
    machine_.update(now_, floor, isBlocked);
  }
  /// From moving on until the door closes.
  void serve(int floor) {
    cabinIsThere_ = doorIsThere_ = true;
    update(floor);
    cabinIsThere_ = false;
    update(floor);
    letTheDoorClose(floor);
  }
  /// From when it is open.
  void letTheDoorClose(int floor) {
    for (int i = 0; i < 4; ++i) update(floor);
    EXPECT_EQ(machine_.phase(), Phase::kWaiting);
    doorIsThere_ = false;
    update(floor);
    EXPECT_EQ(machine_.phase(), Phase::kClosing);
    doorIsThere_ = true;
  }
  Orders orders() { return std::exchange(orders_, {}); }

  bool cabinIsThere_ = false, doorIsThere_ = false;
  Orders orders_;
  Time now_{0};
  ElevatorMachine machine_ = make();
};

TEST_F(ElevatorMachineTest, GoesToAFloorOpensWaitsAndCloses) {
  update(0);
  machine_.call(2);
  EXPECT_EQ(machine_.phase(), Phase::kMoving);
  update(1);
  EXPECT_EQ(machine_.phase(), Phase::kMoving);
  cabinIsThere_ = true;
  update(2);
  EXPECT_EQ(machine_.phase(), Phase::kOpening);
  update(2);
  EXPECT_EQ(machine_.phase(), Phase::kOpening);
  doorIsThere_ = true;
  update(2);
  EXPECT_EQ(machine_.phase(), Phase::kWaiting);
  letTheDoorClose(2);
  update(2);
  EXPECT_EQ(machine_.phase(), Phase::kIdle);
  EXPECT_EQ(orders(), (Orders{"cabin 2", "open 2", "close 2"}));
}

TEST_F(ElevatorMachineTest, OpensTheDoorWhereItStands) {
  update(1);
  machine_.call(1);
  EXPECT_EQ(orders(), Orders{"open 1"});
}

TEST_F(ElevatorMachineTest, HeedsCallsWhenTheDoorCloses) {
  update(0);
  machine_.call(1);
  machine_.call(3);
  machine_.call(2);
  machine_.call(3);
  serve(1);
  EXPECT_EQ(machine_.phase(), Phase::kClosing);
  update(1);
  serve(2);
  update(2);
  EXPECT_EQ(orders(), (Orders{"cabin 1", "open 1", "close 1", "cabin 2", "open 2", "close 2", "cabin 3"}));
}

TEST_F(ElevatorMachineTest, ServesInPassingWhatIsOnItsWay) {
  update(0);
  machine_.call(0);
  doorIsThere_ = true;
  update(0);
  for (const int floor : {3, 0, 1, 2}) machine_.call(floor);
  letTheDoorClose(0);
  Orders served;
  for (int i = 0; i < 4; ++i) {
    update(0);
    served.push_back(orders().back());
    serve(served.back().back() - '0');
    orders();
  }
  // between floor 0, where it stands, and 3 lie 0, 1 and 2
  EXPECT_EQ(served, (Orders{"cabin 0", "cabin 1", "cabin 2", "cabin 3"}));
}

TEST_F(ElevatorMachineTest, KeepsABlockedDoorOpen) {
  update(0);
  machine_.call(0);
  doorIsThere_ = true;
  update(0);
  for (int i = 0; i < 20; ++i) update(0, true);
  EXPECT_EQ(machine_.phase(), Phase::kWaiting);
  // from when it is free again
  update(0);
  letTheDoorClose(0);
}

TEST_F(ElevatorMachineTest, GoesOnFromASavedState) {
  update(0);
  machine_.call(1);
  machine_.call(3);
  StateArchive taking;
  machine_.transfer(taking, kFloors);
  const std::vector<std::byte> bytes = taking.take();
  machine_.reset();
  EXPECT_EQ(machine_.phase(), Phase::kIdle);
  orders();
  StateArchive giving{bytes};
  machine_.transfer(giving, kFloors);
  EXPECT_EQ(machine_.phase(), Phase::kMoving);
  serve(1);
  update(1);
  EXPECT_EQ(orders(), (Orders{"open 1", "close 1", "cabin 3"}));
}

TEST_F(ElevatorMachineTest, RefusesAStateWithFloorsThatAreNotThere) {
  update(0);
  machine_.call(3);
  StateArchive taking;
  machine_.transfer(taking, kFloors);
  std::vector<std::byte> bytes = taking.take();
  StateArchive ofFewer{bytes};
  EXPECT_THROW(machine_.transfer(ofFewer, kFloors - 1), std::out_of_range);
  // the phase
  bytes[0] = std::byte{5};
  StateArchive forged{bytes};
  EXPECT_THROW(machine_.transfer(forged, kFloors), std::out_of_range);
}

}  // namespace
}  // namespace pongsim::elevator_machine_test
