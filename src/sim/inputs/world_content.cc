#include "sim/inputs/world_content.hh"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <variant>

#include "base/hash.hh"
#include "base/regular_file.hh"
#include "sdf/includes/addresses.hh"
#include "sdf/loader.hh"
#include "sdf/text/document.hh"
#include "sdf/text/print.hh"

namespace pongsim::sim {

namespace {

/// Largest file whose content is hashed.
constexpr std::uint64_t kLargestFile = std::uint64_t{4} << 30;

void collectPaths(const Element& element, std::set<std::string>& paths) {
  constexpr std::string_view kScheme = "file://";
  const std::string_view text = element.text;
  if (text.starts_with('/')) paths.emplace(text);
  if (text.starts_with(kScheme)) paths.emplace(text.substr(kScheme.size()));
  for (const Element& child : element.children) collectPaths(child, paths);
}

std::string attributeText(const Element::Attribute* attribute) {
  return attribute == nullptr ? "none" : "'" + attribute->value + "'";
}

std::string nameOf(const Element& element) {
  const std::string name = element.attributeOr("name", "");
  return name.empty() ? element.name : element.name + " '" + name + "'";
}

/// @param place Of the elements: "model 'box', link 'link'".
std::string firstDifference(const Element& a, const Element& b, const std::string& place) {
  for (const Element::Attribute& attribute : a.attributes) {
    const Element::Attribute* other = b.attribute(attribute.name);
    if (other != nullptr && other->value == attribute.value) continue;
    return place + ", attribute " + attribute.name + ": '" + attribute.value + "' and " + attributeText(other);
  }
  for (const Element::Attribute& attribute : b.attributes) {
    if (a.attribute(attribute.name) == nullptr) {
      return place + ", attribute " + attribute.name + ": none and '" + attribute.value + "'";
    }
  }
  if (a.text != b.text) return place + ": '" + a.text + "' and '" + b.text + "'";
  for (std::size_t i = 0; i < std::max(a.children.size(), b.children.size()); ++i) {
    const std::string before = place.empty() ? "" : place + ", ";
    if (i == a.children.size()) return before + nameOf(b.children[i]) + " is only in the second";
    if (i == b.children.size()) return before + nameOf(a.children[i]) + " is only in the first";
    if (nameOf(a.children[i]) != nameOf(b.children[i])) {
      return before + nameOf(a.children[i]) + " is in the first where the second has " + nameOf(b.children[i]);
    }
    std::string found = firstDifference(a.children[i], b.children[i], before + nameOf(a.children[i]));
    if (!found.empty()) return found;
  }
  return {};
}

}  // namespace

std::optional<WorldContent> contentOf(const std::filesystem::path& file) {
  Diagnostics diagnostics;
  std::optional<Element> root = sdf::resolveFile(file, diagnostics);
  if (!root) return std::nullopt;
  sdf::makeAddressesAbsolute(*root, file.parent_path());
  WorldContent content;
  content.sdf = sdf::printDocument(*root);
  std::set<std::string> paths;
  collectPaths(*root, paths);
  for (const std::string& path : paths) {
    const auto read = base::readRegularFile(path, kLargestFile);
    const auto* text = std::get_if<std::string>(&read);
    if (text == nullptr) continue;
    base::Hash hash;
    hash.add(*text);
    content.files.push_back({path, hash.value()});
  }
  return content;
}

std::string firstDifference(const WorldContent& a, const WorldContent& b) {
  if (a.sdf != b.sdf) {
    Diagnostics diagnostics;
    const auto rootOf = [&diagnostics](const std::string& text) {
      return sdf::parseDocument(text, std::make_shared<const std::string>("sdf"), diagnostics);
    };
    const std::optional<Element> rootA = rootOf(a.sdf);
    const std::optional<Element> rootB = rootOf(b.sdf);
    std::string found = rootA && rootB ? firstDifference(*rootA, *rootB, "") : std::string();
    if (!found.empty()) return found;
  }
  for (const RunStart::File& file : a.files) {
    const auto other = std::ranges::find(b.files, file.path, &RunStart::File::path);
    if (other != b.files.end() && other->hash != file.hash) return "file '" + file.path + "' has another content";
  }
  return {};
}

}  // namespace pongsim::sim
