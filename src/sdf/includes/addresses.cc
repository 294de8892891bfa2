#include "sdf/includes/addresses.hh"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>

#include "pongsim/files/fuel_address.hh"

namespace pongsim::sdf {

namespace fs = std::filesystem;

namespace {

/// @return Whether elements with this name may contain a file's address.
bool isAddress(std::string_view name) {
  // the last two are textures of a heightmap; in a material they are colours, whose text names no file
  constexpr std::array<std::string_view, 4> kNames{"uri", "filename", "diffuse", "normal"};
  return std::ranges::find(kNames, name) != kNames.end() || name.ends_with("_map");
}

}  // namespace

void makeAddressesAbsolute(Element& element, const fs::path& folder) {
  if (element.name == "plugin") return;
  std::error_code error;
  const fs::path path(element.text);
  if (isAddress(element.name) && !element.text.empty() && path.is_relative() && fs::exists(folder / path, error)) {
    element.text = fs::absolute(folder / path, error).lexically_normal().string();
  }
  for (Element& child : element.children) makeAddressesAbsolute(child, folder);
}

std::vector<std::string> fuelAddressesIn(const Element& element) {
  std::vector<std::string> addresses;
  const auto collect = [&](const Element& each, const auto& self) -> void {
    if (isAddress(each.name) && isFuelAddress(each.text)) addresses.push_back(each.text);
    for (const Element& child : each.children) self(child, self);
  };
  collect(element, collect);
  return addresses;
}

}  // namespace pongsim::sdf
