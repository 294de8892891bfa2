// Arbitrary bytes as a robot file.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "load_whole.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // other content is the sdf fuzzer's
  constexpr int kOfNoInterest = -1;
  if (text.find("<robot") == text.npos) return kOfNoInterest;
  pongsim::fuzz::loadWhole(text, "robot.urdf");
  return 0;
}
