#include "plugin/library.hh"

#include <cstdint>
#include <string>

#include "base/shared_library.hh"
#include "plugin/interface_version.hh"

namespace pongsim::plugin {

namespace {

std::string otherVersion(std::uint32_t version) {
  return "it is built for version " + std::to_string(version) + " of pongsim's plugin interface, this is version " +
         std::to_string(kAbiVersion) + (version < kAbiVersion ? ": rebuild it" : ": it needs a newer pongsim");
}

/// @return Why a library can't be opened, with advice if pongsim lacks something that it needs.
std::string withAdvice(const std::string& why) {
  const auto has = [&why](const char* text) { return why.find(text) != std::string::npos; };
  const bool wantsOther = has("libpongsim.so.") || (has("undefined symbol") && has("7pongsim"));
  return wantsOther ? why + ": it was built for another version of pongsim; rebuild it" : why;
}

}  // namespace

std::variant<std::unique_ptr<Library>, std::string> Library::open(const std::filesystem::path& file) {
  if (const auto version = interfaceVersion(file); version && *version != kAbiVersion) return otherVersion(*version);
  const auto opened = base::SharedLibrary::open(file);
  if (const auto* why = std::get_if<std::string>(&opened)) return withAdvice(*why);
  const auto& library = std::get<base::SharedLibrary>(opened);
  const auto* table = library.find<const SystemTable>("pongsim_systems");
  if (table == nullptr) return "it does not export any pongsim system";
  if (table->abiVersion != kAbiVersion) return otherVersion(table->abiVersion);
  return std::unique_ptr<Library>(new Library(file, table, library.find<const EncoderTable>("pongsim_encoder")));
}

}  // namespace pongsim::plugin
