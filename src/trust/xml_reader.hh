#pragma once

#include <tinyxml2.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pongsim/program/keystore.hh"

namespace pongsim::trust {

/// @throws KeystoreError with the file, the element's line and the fault.
[[noreturn]] inline void refuse(const std::filesystem::path& file, const tinyxml2::XMLElement& element,
                                const std::string& reason) {
  throw KeystoreError(file.string() + ":" + std::to_string(element.GetLineNum()) + ": " + reason);
}

/// @return The first child with this name.
/// @throws KeystoreError if there is none.
inline const tinyxml2::XMLElement& childOf(const std::filesystem::path& file, const tinyxml2::XMLElement& parent,
                                           const char* name) {
  const tinyxml2::XMLElement* child = parent.FirstChildElement(name);
  if (child == nullptr) {
    refuse(file, parent, "<" + std::string(parent.Name()) + "> has no <" + std::string(name) + ">");
  }
  return *child;
}

/// @return The element's text, without leading and trailing spaces.
/// @throws KeystoreError if it is empty.
std::string textOf(const std::filesystem::path& file, const tinyxml2::XMLElement& element);

/// @return The domains listed in `<domains>`: the first and last of each range.
/// @throws KeystoreError
std::vector<std::pair<int, int>> domainsIn(const std::filesystem::path& file, const tinyxml2::XMLElement& domains);

/// @return Whether the domain is in one of the ranges from `domainsIn`.
bool cover(const std::vector<std::pair<int, int>>& domains, int domain);

/// Parses a document whose root is `<dds>`.
/// @throws KeystoreError
void parseDocument(const std::filesystem::path& file, const std::string& text, tinyxml2::XMLDocument& document);

}  // namespace pongsim::trust
