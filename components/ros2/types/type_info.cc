#include "ros2/types/type_info.hh"

#include "ros2/types/type_hash.hh"

namespace pongsim::ros2 {

namespace {
constexpr std::string_view kBetween = "::dds_::";
}

TypeInfo typeInfo(const TypeDescription& type) { return {type.name, typeHash(type), nullptr}; }

std::string ddsTypeName(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  std::string text;
  for (const char letter : name.substr(0, slash)) {
    if (letter == '/') {
      text += "::";
    } else {
      text += letter;
    }
  }
  return text + std::string(kBetween) + std::string(name.substr(slash + 1)) + "_";
}

std::string rosTypeName(std::string_view ddsName) {
  const std::size_t between = ddsName.find(kBetween);
  if (between == std::string_view::npos || !ddsName.ends_with('_')) return {};
  std::string text(ddsName.substr(0, between));
  if (const std::size_t colons = text.find("::"); colons != std::string::npos) text.replace(colons, 2, "/");
  const std::string_view last = ddsName.substr(between + kBetween.size());
  return text + "/" + std::string(last.substr(0, last.size() - 1));
}

}  // namespace pongsim::ros2
