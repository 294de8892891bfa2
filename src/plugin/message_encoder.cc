#include "pongsim/messages/message_encoder.hh"

#include <filesystem>
#include <optional>

#include "plugin/fortress_systems.hh"
#include "plugin/inspection.hh"
#include "plugin/library.hh"
#include "plugin/loader.hh"

namespace pongsim {

TopicEncoder::~TopicEncoder() = default;
MessageEncoder::~MessageEncoder() = default;

std::unique_ptr<MessageEncoder> makeMessageEncoder(std::string_view name, const EncoderSettings& settings,
                                                   Diagnostics& diagnostics) {
  const std::string library = "pongsim-" + std::string(name) + "-system";
  const std::optional<std::filesystem::path> file = plugin::findLibrary(plugin::defaultSearchPath(), library);
  if (!file) {
    const std::string package(plugin::packageOf(name));
    diagnostics.error({}, "the message encoder of '" + std::string(name) + "' is not installed",
                      package.empty() ? "" : "the package " + package + " has it: apt-get install " + package);
    return nullptr;
  }
  auto opened = plugin::Library::open(*file);
  if (const auto* why = std::get_if<std::string>(&opened)) {
    diagnostics.error(
        {}, "the message encoder of '" + std::string(name) + "' can't be loaded from " + file->string() + ": " + *why);
    return nullptr;
  }
  // the table remains valid, because libraries stay loaded
  const EncoderTable* table = std::get<std::unique_ptr<plugin::Library>>(opened)->encoder();
  if (table == nullptr) {
    diagnostics.error({}, file->string() + " is not a message encoder");
    return nullptr;
  }
  return table->make(settings, diagnostics);
}

}  // namespace pongsim
