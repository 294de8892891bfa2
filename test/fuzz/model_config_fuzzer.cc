// Arbitrary bytes as a model.config. The reader must end, and return a file or add an error.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "require.hh"
#include "sdf/includes/model_config.hh"
#include "support/temp_folder.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const pongsim::test::TempFolder folder;
  const auto file = folder.write("model.config", std::string_view(reinterpret_cast<const char*>(data), size));
  pongsim::Diagnostics diagnostics;
  const auto found =
      pongsim::sdf::readModelConfig(file, std::make_shared<const std::string>("model.config"), diagnostics);
  pongsim::fuzz::require(found.has_value() || diagnostics.hasErrors());
  return 0;
}
