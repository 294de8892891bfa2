#include "sdf/version.hh"

#include <algorithm>
#include <limits>
#include <string>

#include "base/parse_number.hh"

namespace pongsim::sdf {

std::optional<int> parseVersion(std::string_view text) {
  if (!text.starts_with("1.")) return std::nullopt;
  const std::optional<long long> minor = base::parseInteger(text.substr(2));
  if (!minor || *minor < 0) return std::nullopt;
  return static_cast<int>(std::min<long long>(*minor, std::numeric_limits<int>::max()));
}

int readVersion(const Element& root, Diagnostics& diagnostics) {
  const Element::Attribute* attribute = root.attribute("version");
  if (attribute == nullptr) {
    diagnostics.error(root.position, "<sdf> has no version", "write <sdf version=\"1.9\">");
    return kFortressVersion;
  }
  const std::string& text = attribute->value;
  const std::optional<int> minor = parseVersion(text);
  if (!minor) {
    diagnostics.error(attribute->position, "'" + text + "' is not a version of SDF", "the versions are 1.4 to 1.12");
    return kFortressVersion;
  }
  const int version = std::clamp(*minor, kOldestVersion, kNewestVersion);
  if (version != *minor) {
    diagnostics.warning(attribute->position,
                        "SDF " + text + " is not supported: reading the file as SDF 1." + std::to_string(version));
  }
  return version;
}

}  // namespace pongsim::sdf
