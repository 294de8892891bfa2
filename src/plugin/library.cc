#include "plugin/library.hh"

#include <dlfcn.h>

namespace pongsim::plugin {

std::variant<std::unique_ptr<Library>, std::string> Library::open(const std::filesystem::path& file) {
  // it stays when it is closed: message types that came with it can't be taken back, and not be added twice either
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) return std::string(dlerror());
  const auto* table = static_cast<const SystemTable*>(dlsym(handle, "pongsim_systems"));
  std::string reason;
  if (table == nullptr) {
    reason = "it does not export any pongsim system";
  } else if (table->abiVersion != kAbiVersion) {
    reason = "it was built for version " + std::to_string(table->abiVersion) +
             " of pongsim's plugin interface, this is " + "version " + std::to_string(kAbiVersion) +
             (table->abiVersion < kAbiVersion ? ": build it anew" : "");
  } else {
    return std::unique_ptr<Library>(new Library(file, handle, table));
  }
  dlclose(handle);
  return reason;
}

Library::~Library() { dlclose(handle_); }

}  // namespace pongsim::plugin
