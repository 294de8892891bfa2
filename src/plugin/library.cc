#include "plugin/library.hh"

#include <dlfcn.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "plugin/interface_version.hh"

namespace pongsim::plugin {

namespace {

std::string otherVersion(std::uint32_t version) {
  return "it was built for version " + std::to_string(version) + " of pongsim's plugin interface, this is version " +
         std::to_string(kAbiVersion) +
         (version < kAbiVersion ? ": it is too old, build it anew" : ": this pongsim is too old for it");
}

/// @return Why the last library was not loaded, with what is to be done where pongsim lacks something that it wants.
std::string whyNotLoaded() {
  std::string reason = dlerror();
  const std::string_view text = reason;
  const bool wantsOther =
      text.find("libpongsim.so.") != std::string_view::npos ||
      (text.find("undefined symbol") != std::string_view::npos && text.find("7pongsim") != std::string_view::npos);
  return wantsOther ? reason + ": it was built for another version of pongsim, build it anew" : reason;
}

}  // namespace

std::variant<std::unique_ptr<Library>, std::string> Library::open(const std::filesystem::path& file) {
  if (const auto version = interfaceVersion(file); version && *version != kAbiVersion) return otherVersion(*version);
  // it stays when it is closed: message types that came with it can't be taken back, and not be added twice either
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) return whyNotLoaded();
  const auto* table = static_cast<const SystemTable*>(dlsym(handle, "pongsim_systems"));
  if (table != nullptr && table->abiVersion == kAbiVersion) {
    return std::unique_ptr<Library>(new Library(file, handle, table));
  }
  const std::string reason =
      table == nullptr ? "it does not export any pongsim system" : otherVersion(table->abiVersion);
  dlclose(handle);
  return reason;
}

Library::~Library() { dlclose(handle_); }

}  // namespace pongsim::plugin
