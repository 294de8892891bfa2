#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

#include "web/server/limits.hh"
#include "web/server/session.hh"

namespace pongsim::web {

/// What waits for one client. What must not be lost leaves first and in order; data leaves by turns, key by key. For
/// any thread.
class Outbox {
 public:
  struct Item {
    bool isText = false;
    Frame frame;
  };

  explicit Outbox(const ServerLimits& limits) : limits_(limits) {}

  /// Adds what must not be lost.
  /// @return Whether there was room.
  bool add(Item item);
  /// As `Client::sendData`.
  void addData(std::uint64_t key, std::size_t most, Frame frame);
  /// As `Client::sendWhenFree`.
  void addMaker(std::uint64_t key, std::function<Frame()> make);
  /// Drops what waits of that key.
  void forget(std::uint64_t key);
  /// Drops all.
  void clear();

  /// @return What is to leave next, made now where it is made when the socket is free; nothing where nothing waits.
  /// What a maker throws comes through.
  std::optional<Item> take();
  bool isEmpty() const;
  std::uint64_t dropped() const;

 private:
  struct Waiting {
    Frame frame;
    std::function<Frame()> make;
  };
  /// Of one key.
  struct Line {
    std::deque<Waiting> waiting;
    std::list<std::uint64_t>::iterator turn;
  };

  void addWaiting(std::uint64_t key, std::size_t most, Waiting waiting);
  std::optional<Waiting> takeData();

  const ServerLimits& limits_;
  mutable std::mutex mutex_;
  std::deque<Item> first_;
  std::size_t firstBytes_ = 0;
  std::unordered_map<std::uint64_t, Line> lines_;
  /// Keys that have something, in the order of their turns.
  std::list<std::uint64_t> turns_;
  std::size_t dataBytes_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace pongsim::web
