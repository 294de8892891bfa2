#include "plugin/system_name.hh"

#include <cctype>

namespace pongsim::plugin {

namespace {

void removePrefix(std::string_view& name, std::string_view prefix) {
  if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
}

void removeSuffix(std::string_view& name, std::string_view suffix) {
  if (name.ends_with(suffix)) name.remove_suffix(suffix.size());
}

/// Removes the prefix `family`, the digits of a version after it, and the following hyphen.
/// @return Whether `name` had this prefix.
bool removeFamily(std::string_view& name, std::string_view family) {
  if (!name.starts_with(family)) return false;
  std::string_view rest = name.substr(family.size());
  while (!rest.empty() && std::isdigit(static_cast<unsigned char>(rest.front())) != 0) rest.remove_prefix(1);
  if (!rest.starts_with('-')) return false;
  name = rest.substr(1);
  return true;
}

}  // namespace

std::string systemName(std::string_view filename) {
  std::string_view name = filename;
  removePrefix(name, "lib");
  removeSuffix(name, ".so");
  for (std::string_view family : {"ignition-gazebo", "gz-sim", "ignition-launch", "gz-launch", "pongsim"}) {
    if (removeFamily(name, family)) {
      removeSuffix(name, "-system");
      break;
    }
  }
  // Gazebo's server, whose clients the system Web serves
  return name == "websocket-server" ? "web" : std::string(name);
}

}  // namespace pongsim::plugin
