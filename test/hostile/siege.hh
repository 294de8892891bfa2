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

/// State and throughput of a running world during an attack.
struct Figures {
  double seconds = 0;
  std::uint64_t memoryBefore = 0, memoryMost = 0, memoryAfter = 0;
  /// Messages received on the world's clock, one per step, and from the publisher.
  std::uint64_t steps = 0, messages = 0;
  /// Threads and open files of the world's process.
  std::size_t threadsBefore = 0, threadsAfter = 0, descriptorsBefore = 0, descriptorsAfter = 0;
  /// Time from the end of the attack until a new subscriber received the clock, at most `kDeadline` [s].
  double recovery = 0;
  /// Time from the end of the attack until the list of topics was as before [s].
  double clean = 0;
  bool isHeardAfterwards = false, isListedAsBefore = false;
  /// Output of the attacker.
  std::string attacker;
};

/// A running world in one process, a publisher in another, and this process, which subscribes to both.
class Siege {
 public:
  /// Starts both, and waits for their messages.
  /// @throws std::runtime_error if there are none within `kDeadline`.
  Siege();

  /// Measures without an attack.
  Figures rest(std::chrono::milliseconds duration);
  /// Measures during an attack and the recovery from it.
  /// @param arguments Of `pongsim_rtps_fuzz`, without domain and duration.
  Figures attack(const std::vector<std::string>& arguments, std::chrono::milliseconds duration);

  /// @return Whether the world's process still runs, and ends with code 0 on SIGINT.
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
