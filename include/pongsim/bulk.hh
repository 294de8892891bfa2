#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace pongsim {

/// The large part of a message, such as pixels or points, kept outside of it. It is written once, directly to each
/// subscriber's destination, instead of being copied into the message first.
struct Bulk {
  /// The message's `bytes` field that it replaces; the message leaves it empty.
  const char* field = "data";
  std::size_t size = 0;
  /// Writes the bytes; the same in each call.
  std::function<void(std::span<std::byte>)> write;
};

}  // namespace pongsim
