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

/// @throws KeystoreError that names the file, the element's line, and what is wrong there.
[[noreturn]] inline void refuse(const std::filesystem::path& file, const tinyxml2::XMLElement& element,
                                const std::string& reason) {
  throw KeystoreError(file.string() + ":" + std::to_string(element.GetLineNum()) + ": " + reason);
}

/// @return The first child of that name.
/// @throws KeystoreError where there is none.
inline const tinyxml2::XMLElement& childOf(const std::filesystem::path& file, const tinyxml2::XMLElement& parent,
                                           const char* name) {
  const tinyxml2::XMLElement* child = parent.FirstChildElement(name);
  if (child == nullptr) {
    refuse(file, parent, "<" + std::string(parent.Name()) + "> has no <" + std::string(name) + ">");
  }
  return *child;
}

/// @return What stands in the element, without blanks at its ends.
/// @throws KeystoreError where nothing does.
std::string textOf(const std::filesystem::path& file, const tinyxml2::XMLElement& element);

/// @return The domains that `<domains>` names, from the first to the second of each pair.
/// @throws KeystoreError
std::vector<std::pair<int, int>> domainsIn(const std::filesystem::path& file, const tinyxml2::XMLElement& domains);

/// @return Whether the domain is in one of the pairs that `domainsIn` returns.
bool cover(const std::vector<std::pair<int, int>>& domains, int domain);

/// Parses a document whose root is `<dds>`.
/// @throws KeystoreError
void parseDocument(const std::filesystem::path& file, const std::string& text, tinyxml2::XMLDocument& document);

}  // namespace pongsim::trust
