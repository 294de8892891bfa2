#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace pongsim::ros2 {

/// Writes bytes to their place, all of it.
using Fill = std::function<void(std::span<std::byte>)>;

/// Stands in a type for its `uint8[]` where the bytes are elsewhere yet: whoever writes the type to the wire has them
/// written to their place there. It is for writing only.
struct BulkBytes {
  std::size_t size = 0;
  Fill fill = {};
};

}  // namespace pongsim::ros2
