#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fault.hh"
#include "pongsim/interception.hh"
#include "pongsim/log.hh"
#include "pongsim/random.hh"
#include "pongsim/state/state_archive.hh"

namespace pongsim::faults {

/// The faults of a topic, which act on each message one after the other, in the
/// order in which they were added.
class TopicFaults {
 public:
  /// @throws std::invalid_argument if somebody else intercepts the topic.
  TopicFaults(const Node& node, std::string topic, const Logger& log);

  const std::string& topic() const { return topic_; }
  /// @param random Its stream; it is not drawn from before.
  void add(const Fault& fault, const Random& random);
  /// Replaces the stream of a fault.
  void restart(std::size_t stage, const Random& random) { stages_[stage].stream = random; }

  /// Sets the time of the messages that follow.
  void setTime(Time now) { now_ = now; }
  /// Sends delayed messages that are due.
  void release();

  void reset();
  void transfer(StateArchive& archive);

 private:
  struct Passing {
    std::string type;
    std::string bytes;
    bool isIncoming = false;
    bool isCarried = false;
    void transfer(StateArchive& archive);
  };
  struct Delayed {
    Time due{0};
    Passing passing;
    void transfer(StateArchive& archive);
  };
  /// The random numbers of one moment. They depend on it and not on the
  /// messages before, of which there are none for a topic without subscribers.
  struct Draws {
    Time at{-1};
    std::optional<Random> random;
  };
  struct Stage {
    Fault fault;
    Random stream;
    /// Of outgoing and of incoming messages.
    std::array<Draws, 2> draws;
    /// The last message before it was frozen, likewise.
    std::array<std::optional<std::string>, 2> last;
    std::deque<Delayed> delayed;
    bool isFieldUnknown = false;
  };
  using Pass = std::function<void(std::span<const std::byte>)>;

  void take(const Interception::Crossing& crossing);
  void run(std::size_t stage, const Passing& passing, const Pass& pass);
  bool happens(Stage& stage, bool isIncoming);
  Random& randomOf(Stage& stage, bool isIncoming);
  Passing withNoise(Stage& stage, const Passing& passing);

  const std::string topic_;
  const Logger& log_;
  Time now_{0};
  std::vector<Stage> stages_;
  // last: it calls the others
  std::unique_ptr<Interception> interception_;
};

}  // namespace pongsim::faults
