// Arbitrary bytes as a world file.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "load_whole.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pongsim::fuzz::loadWhole({reinterpret_cast<const char*>(data), size}, "world.sdf");
  return 0;
}
