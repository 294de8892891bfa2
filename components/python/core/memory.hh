#pragma once

#include <cstddef>
#include <vector>

namespace pongsim::python {

/// Bytes that NumPy arrays refer to. They stay in place as long as an array uses them.
struct Memory {
  explicit Memory(std::size_t size, bool writable = false) : bytes(size), isWritable(writable) {}
  std::vector<std::byte> bytes;
  bool isWritable;
};

}  // namespace pongsim::python
