#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace pongsim::ign {

/// A serialized message on the heap, whose memory can be passed to ZeroMQ without a copy.
class Payload {
 public:
  /// @throws std::bad_alloc
  explicit Payload(std::size_t size);
  Payload(Payload&& other) noexcept : data_(std::exchange(other.data_, nullptr)), size_(other.size_) {}
  Payload& operator=(Payload&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  ~Payload() { free(data_, nullptr); }

  std::size_t size() const { return size_; }
  std::span<std::byte> bytes() const { return {static_cast<std::byte*>(data_), size_}; }

  /// Releases ownership; the new owner must call `free`.
  char* release() { return static_cast<char*>(std::exchange(data_, nullptr)); }
  /// Has the signature of ZeroMQ's `zmq_free_fn`.
  static void free(void* data, void* hint);

  /// @return The total size of all existing payloads, released or not [bytes].
  static std::size_t total();

 private:
  void* data_;
  std::size_t size_;
};

}  // namespace pongsim::ign
