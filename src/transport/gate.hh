#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/node.hh"
#include "transport/locks.hh"

namespace pongsim::transport {

class Bus;
class Channel;
class DispatchQueue;

/// Lets what comes from outside into a transport at ticks only, as long as it exists: messages of other processes and
/// of carriers (`PublisherOptions::relays`), and requests that the transport's own systems do not make. What its own
/// publishers send passes as always.
///
/// Each named topic is a queue: a tick takes a number of its messages in the order of arrival, and is complete when
/// they are there. What else came before the last of them is taken in with them; what came later waits for the next
/// tick. So it does not matter how early a message comes, nor how late (a Kahn process network: G. Kahn, The semantics
/// of a simple language for parallel programming, 1974).
class Gate {
 public:
  /// How many messages a tick takes of each topic, in the order of the constructor's; 0: it does not wait for that one.
  using Wanted = std::span<const std::uint64_t>;

  /// @param transport Must outlive this, and have no other gate.
  /// @throws std::invalid_argument for an invalid topic name.
  Gate(Transport& transport, const std::vector<std::string>& topics);
  ~Gate();
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

  bool isComplete(Wanted wanted) const;
  /// @return The number of messages that wait on a topic.
  std::size_t waiting(std::size_t topic) const;

  /// Waits until the tick is complete, there are requests for `serve`, or somebody called `Node::wake`.
  /// @return Whether somebody did.
  bool wait(Wanted wanted, std::chrono::nanoseconds timeout);

  /// Handles the requests that came before the tick was complete, and no messages.
  /// @return The number of requests and responses handled.
  std::size_t serve(Wanted wanted);

  /// Takes in the tick's messages, or as many of them as there are, and dispatches. Call `serve` before.
  void pass(Wanted wanted);

  /// While paused, requests are handled whenever they come.
  void setPaused(bool isPaused);

  /// @return Whether somebody outside subscribes to the transport's topic, or to any of its topics if it is empty.
  bool isHeard(std::string_view topic) const;
  /// @return Who publishes on the topic outside, "process 1234"; empty if nobody does.
  std::string publishers(std::string_view topic) const;

  // for Delivery

  const DispatchQueue& queue() const { return queue_; }
  /// Notes that a message from outside is in all its inboxes; the next one gets the number `end`.
  void arrived(const Channel& channel, std::uint64_t end) REQUIRES(waitingRole);
  /// @return The messages from outside with numbers below it are taken in.
  std::uint64_t limitOf(const Channel& channel) const REQUIRES(waitingRole);
  /// Forgets what waits.
  void forget() REQUIRES(waitingRole);

 private:
  /// A message that waits.
  struct Mark {
    /// The number after those that it has in inboxes.
    std::uint64_t end = 0;
    /// The number of the next request when it came.
    std::uint64_t nextRequest = 0;
  };
  struct Topic {
    std::string name;
    std::vector<Mark> marks;
    std::uint64_t limit = 0;
  };

  bool isCompleteNow(Wanted wanted) const REQUIRES(waitingRole);
  /// @return What came with the last message of a tick, or comes next if the tick is not complete.
  Mark lastOf(Wanted wanted) const REQUIRES(waitingRole);

  Bus& bus_;
  DispatchQueue& queue_;
  std::vector<Topic> topics_ GUARDED_BY(waitingRole);
  /// Of topics that are not named.
  std::uint64_t limit_ GUARDED_BY(waitingRole) = 0;
  bool isPaused_ = false;
  /// Without one, messages on a topic would not be received.
  std::vector<Subscription> subscriptions_;
};

}  // namespace pongsim::transport
