#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace pongsim::ros2 {

/// Fast DDS as its users have it, with raw bytes as a type: the reference that the bridge is measured against.
class BarePeer {
 public:
  enum class Transports {
    /// The default: shared memory, and UDP on all interfaces.
    kDefault,
    /// UDP only, like the simulation, with socket buffers large enough for an image, which the system's default is not.
    kUdp
  };
  explicit BarePeer(int domain, Transports transports);
  ~BarePeer();
  BarePeer(const BarePeer&) = delete;
  BarePeer& operator=(const BarePeer&) = delete;

  /// Subscribes to a topic on the wire, reliably.
  void read(const std::string& topic, const std::string& type,
            std::function<void(std::span<const std::byte>)> received);
  /// Creates a writer for one.
  void openWriter(const std::string& topic, const std::string& type);
  void write(std::span<const std::byte> payload);
  /// @return The number of matched endpoints.
  int matched() const { return matched_; }

 private:
  struct Parts;
  std::atomic<int> matched_ = 0;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::ros2
