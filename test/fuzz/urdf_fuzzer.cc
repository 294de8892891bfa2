// Arbitrary bytes as a robot file.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "load_whole.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // other content is for the sdf fuzzer; libFuzzer keeps no input that returns -1
  constexpr int kDiscard = -1;
  if (text.find("<robot") == text.npos) return kDiscard;
  pongsim::fuzz::loadWhole(text, "robot.urdf");
  return 0;
}
