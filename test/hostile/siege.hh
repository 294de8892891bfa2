#pragma once

#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <chrono>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "pongsim/node.hh"
#include "support/process.hh"

namespace pongsim::hostile {

/// What a run is worth while others do it harm.
struct Figures {
  double seconds = 0;
  std::uint64_t memoryBefore = 0, memoryMost = 0, memoryAfter = 0;
  /// Steps of the world that its clock told of, and messages of the other process that were heard.
  std::uint64_t steps = 0, messages = 0;
  /// Of the world's process.
  std::size_t threadsBefore = 0, threadsAfter = 0, descriptorsBefore = 0, descriptorsAfter = 0;
  /// From the end of the attack until somebody new heard the world; the tests' deadline at most.
  double recovery = 0;
  /// From the end of the attack until the lists were what they were before.
  double clean = 0;
  bool isHeardAfterwards = false, isListedAsBefore = false;
  /// The attacker's last words.
  std::string attacker;
};

/// A world that runs in a process of its own, a publisher in another one, and this process, which hears both.
class Siege {
 public:
  /// Waits until everybody hears everybody.
  /// @throws std::runtime_error where that never is.
  Siege();

  /// Lets everything run for that long without an attack.
  Figures rest(std::chrono::milliseconds duration);
  /// The same under attack. Afterwards the world is asked by somebody new.
  /// @param arguments For `pongsim_rtps_fuzz`, but for domain and duration.
  Figures attack(const std::vector<std::string>& arguments, std::chrono::milliseconds duration);

  /// @return Whether the world's process is there, and ends as it should when it is told to.
  bool endsWell();
  const std::string& complaints() const { return complaints_; }

 private:
  void hear(std::chrono::milliseconds duration, Figures& figures);
  bool newcomerHears();
  std::set<std::string> list();

  int domain_;
  test::Process world_;
  test::Process publisher_;
  Transport transport_;
  std::uint64_t steps_ = 0, messages_ = 0;
  Subscription clock_, chatter_;
  std::string complaints_;
};

}  // namespace pongsim::hostile
