#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <vector>

#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim {
class Simulation;
}

namespace pongsim::sim {

/// The last minute of a run as saved states, to which it can go back. They are kept while somebody listens to
/// `/world/W/playback/stats`, which tells the times of the first and the last one. In a world without physics, that
/// topic is left to the system that plays the recording.
class RunHistory {
 public:
  /// Simulated time between two states.
  static constexpr Time kInterval = std::chrono::milliseconds(500);
  static constexpr std::size_t kMostStates = 120;
  /// Older states are forgotten where all together would be larger.
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

  /// @param simulation Must outlive it.
  /// @param isKept If false, it keeps nothing: going back is not an input that a replay could repeat.
  RunHistory(Simulation& simulation, bool isKept);

  /// To be called after each step. Forgets what is later than now: the run has gone back, and goes on from there.
  void stepped();

  /// Publishes the times of the first and the last state, ten times per second of wall time.
  void publishRange(std::chrono::steady_clock::time_point now);

  /// Goes to the last state at or before a time. Refused where there is none, or where models have been inserted or
  /// removed since; this and earlier states are then forgotten.
  Outcome<void> goTo(Time time);

  /// Forgets all states.
  void forget() { states_.clear(); }

 private:
  struct State {
    Time time;
    std::vector<std::byte> bytes;
  };
  void keep();

  Simulation& simulation_;
  Publisher publisher_;
  MessagePointer range_;
  std::deque<State> states_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace pongsim::sim
