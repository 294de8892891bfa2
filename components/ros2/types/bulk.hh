#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace pongsim::ros2 {

/// Writes bytes, filling all of the memory.
using Fill = std::function<void(std::span<std::byte>)>;

/// Replaces a `uint8[]` in a type if the bytes are still elsewhere: when the type is written to the wire, they are
/// written there directly. Only for writing.
struct BulkBytes {
  std::size_t size = 0;
  Fill fill = {};
};

}  // namespace pongsim::ros2
