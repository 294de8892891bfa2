// Any bytes as a world file: whatever they are, the loader ends, and says what is wrong.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  pongsim::Diagnostics diagnostics;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  // nothing is found: what is on the machine has no part in it
  const auto finder = pongsim::assets::finderIn({});
  const pongsim::sdf::Root root = pongsim::sdf::loadText(text, "world.sdf", diagnostics, finder);
  for (const pongsim::Diagnostic& diagnostic : diagnostics.all()) {
    if (format(diagnostic).empty()) std::abort();
  }
  if (!diagnostics.hasErrors() && root.worlds.empty() && root.models.empty() && root.lights.empty()) std::abort();
  return 0;
}
