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

/// The queue of one client. Items that must not be lost are sent first, in order; then data, one frame of each key in
/// turn.
/// For any thread.
class ClientQueue {
 public:
  struct Item {
    bool isText = false;
    Frame frame;
    /// Of data.
    std::optional<std::uint64_t> key = std::nullopt;
  };

  explicit ClientQueue(const ServerLimits& limits) : limits_(limits) {}

  /// Adds an item that must not be lost.
  /// @return Whether there was room.
  bool add(Item item);
  /// See `Client::sendData`.
  void addData(std::uint64_t key, std::size_t most, Frame frame);
  /// See `Client::sendWhenFree`.
  void addMaker(std::uint64_t key, std::function<Frame()> make);
  /// Drops what is queued for this key.
  void forget(std::uint64_t key);
  /// Drops everything.
  void clear();

  /// @return The next item to send, created now if it is made on demand; nothing if the queue is empty. Exceptions from
  /// the functions that make frames pass through.
  std::optional<Item> take();
  bool isEmpty() const;
  std::uint64_t dropped() const;

 private:
  /// A frame, or what makes it.
  struct Data {
    Frame frame;
    std::function<Frame()> make;
    std::uint64_t key;
  };
  /// The queue of one key.
  struct KeyQueue {
    std::deque<Data> frames;
    std::list<std::uint64_t>::iterator turn;
  };

  void addToKey(std::uint64_t key, std::size_t most, Data data);
  std::optional<Data> takeData();

  const ServerLimits& limits_;
  mutable std::mutex mutex_;
  /// Items that must not be lost.
  std::deque<Item> reliable_;
  std::size_t reliableBytes_ = 0;
  std::unordered_map<std::uint64_t, KeyQueue> keys_;
  /// Keys with data, in the order of their turns.
  std::list<std::uint64_t> turns_;
  std::size_t dataBytes_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace pongsim::web
