#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pongsim {
class Transport;
}

namespace pongsim::transport {

class Bus;
class DispatchQueue;

/// What one dispatch takes in from outside the queue's world.
struct Intake {
  /// A subscription of the world: the `subscription`th of this topic and type, from 0.
  struct Place {
    std::string topic;
    std::string type;
    std::uint64_t subscription = 0;
    bool operator==(const Place&) const = default;
  };
  struct Message {
    /// Its index among all messages for the world's subscriptions, its own included.
    std::uint64_t position = 0;
    Place place;
    std::vector<std::byte> bytes;
  };
  /// How many messages of the world itself were left where others from outside came: a full subscription drops the
  /// oldest ones.
  struct Left {
    Place place;
    std::uint64_t count = 0;
  };
  struct Request {
    /// Its index among all requests that the world handles, its own included.
    std::uint64_t position = 0;
    std::string service;
    std::vector<std::byte> bytes;
  };

  std::vector<Message> messages;
  std::vector<Left> left;
  std::vector<Request> requests;

  bool isEmpty() const { return messages.empty() && requests.empty(); }
  void clear();
};

/// Stands between a transport and what comes from outside the world that it belongs to: other processes, other worlds,
/// carriers, and functions of the program. What systems of the world publish and request in its own steps and
/// dispatches passes by. Attached as long as it exists, between two dispatches.
class InputGate {
 public:
  /// Whether the dispatches note what comes from outside in `intake`, or take in what `handOver` gives instead of it:
  /// then messages from outside are dropped, requests of this process get no reply, and those of others wait.
  enum class Use { kNote, kReplace };

  InputGate(Transport& transport, Use use);
  ~InputGate();
  InputGate(const InputGate&) = delete;
  InputGate& operator=(const InputGate&) = delete;

  Use use() const { return use_; }

  /// What was noted since it was last cleared: call it after each dispatch.
  Intake intake;

  /// Gives the next dispatch what it takes in.
  void handOver(Intake next);
  /// A dispatch of requests only, as a world in lockstep makes them while it waits.
  void serve();
  /// Topics and services of the last dispatch that the world does not have: "a subscription to '/cmd_vel'".
  std::vector<std::string> missing;

 private:
  Bus& bus_;
  DispatchQueue& queue_;
  const Use use_;
};

}  // namespace pongsim::transport
