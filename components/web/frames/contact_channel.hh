#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "pongsim/contact.hh"
#include "pongsim/handles.hh"
#include "pongsim/system.hh"
#include "web/server/session.hh"

namespace pongsim::web {

// Format of the contact points of a step, all numbers little endian:
//
//   0  u32  number of points that follow, 40 bytes each:
//           f32  position in the world x, y, z [m]
//           f32  normal, out of the second collision and into the first, x, y, z
//           f32  force on the first collision x, y, z [N]
//           f32  penetration depth [m]

inline constexpr std::size_t kContactHead = 4;
inline constexpr std::size_t kContactEntry = 40;
/// Of more, the first ones are sent.
inline constexpr std::size_t kMostContacts = 10'000;

/// The channel on which a page gets the contacts of a world, also without contact sensors, at most 20 times per second
/// and only if they have changed. May outlive the world.
class ContactChannel final : public OwnChannel, public std::enable_shared_from_this<ContactChannel> {
 public:
  /// @param wake Makes the world step soon, even if it is paused.
  ContactChannel(const std::string& world, std::function<void()> wake);

  std::string topic() const override { return topic_; }
  std::string schemaName() const override { return "pongsim.Contacts"; }
  std::shared_ptr<void> open(const std::shared_ptr<Client>& client, std::uint64_t key,
                             std::function<std::string(std::uint64_t timeNs)> head) override;
  std::string ask(const std::shared_ptr<void>&, const nlohmann::json&) override {
    return "contacts come by themselves";
  }

  // For the simulation's thread.

  /// Call after each step; while nobody watches it only reads a flag.
  void update(const World& world, const StepInfo& step) {
    if (isWatched_.load(std::memory_order_relaxed)) send(world, step);
  }
  /// Call when the world ends.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  struct Viewer;

  void send(const World& world, const StepInfo& step);

  const std::string topic_;
  std::atomic<bool> isWatched_ = false;
  std::mutex mutex_;
  std::function<void()> wake_;
  std::vector<std::shared_ptr<Viewer>> viewers_;
  // used on the simulation's thread
  Clock::time_point next_{};
  std::vector<Contact> contacts_;
};

/// Encodes contact points.
Payload encodeContacts(const std::vector<Contact>& contacts);

}  // namespace pongsim::web
