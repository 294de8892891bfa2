#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace pongsim::ros2 {

/// Fast DDS as its users have it, with the bytes of a payload for a type: what the bridge is measured beside.
class BarePeer {
 public:
  enum class Way {
    /// As it comes: shared memory, and UDP on all interfaces.
    kDefault,
    /// By UDP alone, as the simulation.
    kUdp
  };
  explicit BarePeer(int domain, Way way);
  ~BarePeer();
  BarePeer(const BarePeer&) = delete;
  BarePeer& operator=(const BarePeer&) = delete;

  /// Listens on a topic of the wire, reliably.
  void read(const std::string& topic, const std::string& type,
            std::function<void(std::span<const std::byte>)> received);
  /// Begins to write on one.
  void openWriter(const std::string& topic, const std::string& type);
  void write(std::span<const std::byte> payload);
  /// @return How many endpoints the others have for ours.
  int matched() const { return matched_; }

 private:
  struct Parts;
  std::atomic<int> matched_ = 0;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::ros2
