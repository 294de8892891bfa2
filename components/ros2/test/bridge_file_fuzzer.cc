// Arbitrary text as a configuration of ros_gz_bridge. It must be read or refused, with a reason for each error; the
// same text gives the same again.

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/require.hh"
#include "ros2/config/bridge_file.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pongsim;
  // a copy, so that the sanitizer detects reads past its end
  const std::string text(reinterpret_cast<const char*>(data), size);
  Diagnostics diagnostics, again;
  const auto rules = ros2::readBridgeText(text, "bridge.yaml", diagnostics);
  for (const Diagnostic& each : diagnostics.all()) fuzz::require(!each.message.empty());
  fuzz::require(ros2::readBridgeText(text, "bridge.yaml", again).size() == rules.size());
  fuzz::require(again.all().size() == diagnostics.all().size());
  return 0;
}
