#include "plugin/library.hh"

#include "base/shared_library.hh"

namespace pongsim::plugin {

std::variant<std::unique_ptr<Library>, std::string> Library::open(const std::filesystem::path& file) {
  const auto opened = base::SharedLibrary::open(file);
  if (const auto* why = std::get_if<std::string>(&opened)) return *why;
  const auto* table = std::get<base::SharedLibrary>(opened).find<const SystemTable>("pongsim_systems");
  if (table == nullptr) return "it does not export any pongsim system";
  if (table->abiVersion != kAbiVersion) {
    return "it was built for version " + std::to_string(table->abiVersion) +
           " of pongsim's plugin interface, this is version " + std::to_string(kAbiVersion) +
           (table->abiVersion < kAbiVersion ? ": build it anew" : "");
  }
  return std::unique_ptr<Library>(new Library(file, table));
}

}  // namespace pongsim::plugin
