#include "base/shared_library.hh"

#include <dlfcn.h>

#include <stdexcept>
#include <system_error>

namespace pongsim::base {

std::variant<SharedLibrary, std::string> SharedLibrary::open(const std::string& name) {
  // never closed: message types registered by a system can't be unregistered, nor registered twice
  void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle == nullptr) return std::string(dlerror());
  return SharedLibrary(handle);
}

SharedLibrary SharedLibrary::require(const std::string& name, const std::string& package) {
  const auto opened = open(name);
  if (const auto* why = std::get_if<std::string>(&opened)) {
    throw std::runtime_error(*why + " (apt-get install " + package + ")");
  }
  return std::get<SharedLibrary>(opened);
}

void* SharedLibrary::address(const char* name) const { return dlsym(handle_, name); }

void* SharedLibrary::requiredAddress(const char* name) const {
  void* found = address(name);
  if (found == nullptr) throw std::runtime_error(dlerror());
  return found;
}

std::filesystem::path ownLibraryFile() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&ownLibraryFile), &info) == 0 || info.dli_fname == nullptr) return {};
  std::error_code ignored;
  return std::filesystem::canonical(info.dli_fname, ignored);
}

}  // namespace pongsim::base
