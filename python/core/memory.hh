#pragma once

#include <cstddef>
#include <vector>

namespace pongsim::python {

/// Bytes that NumPy looks at where they are. They stay where they are for as long as anybody looks.
struct Memory {
  explicit Memory(std::size_t size, bool writable = false) : bytes(size), isWritable(writable) {}
  std::vector<std::byte> bytes;
  bool isWritable;
};

}  // namespace pongsim::python
