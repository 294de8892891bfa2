#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace pongsim {

/// The bulk of a message, its pixels or points, that is elsewhere yet: it is written to where each listener wants it,
/// once, in place of being copied into the message and from there.
struct Bulk {
  /// The message's field of bytes that it belongs to, which the message leaves empty.
  const char* field = "data";
  std::size_t size = 0;
  /// Writes so many bytes; the same in each call.
  std::function<void(std::span<std::byte>)> write;
};

}  // namespace pongsim
