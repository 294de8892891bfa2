#include "sdf/loader.hh"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "base/parse_number.hh"
#include "sdf/document.hh"
#include "sdf/element_check.hh"
#include "sdf/file_text.hh"
#include "sdf/names.hh"
#include "sdf/world_reader.hh"

namespace pongsim::sdf {

namespace {

using FileName = std::shared_ptr<const std::string>;

constexpr int kOldestVersion = 4;
constexpr int kNewestVersion = 9;

/// @return The y of "1.y", within what is supported; nothing, and an error added, where it is not a version.
std::optional<int> readVersion(const Element& root, Diagnostics& diagnostics) {
  const Element::Attribute* attribute = root.attribute("version");
  if (attribute == nullptr) {
    diagnostics.error(root.position, "<sdf> has no version", "write <sdf version=\"1.9\">");
    return std::nullopt;
  }
  const std::string& text = attribute->value;
  const std::optional<long long> minor =
      text.starts_with("1.") ? base::parseInteger(std::string_view(text).substr(2)) : std::nullopt;
  if (!minor || *minor < 0) {
    diagnostics.error(attribute->position, "'" + text + "' is not a version of SDF", "the versions are 1.4 to 1.9");
    return std::nullopt;
  }
  if (*minor < kOldestVersion || *minor > kNewestVersion) {
    const auto nearest = static_cast<int>(std::clamp<long long>(*minor, kOldestVersion, kNewestVersion));
    diagnostics.warning(attribute->position,
                        "SDF " + text + " is not supported: the file is read as SDF 1." + std::to_string(nearest));
    return nearest;
  }
  return static_cast<int>(*minor);
}

Root readRoot(const Element& element, Diagnostics& diagnostics) {
  Root root;
  if (element.name != "sdf") {
    diagnostics.error(element.position, "the file begins with <" + element.name + ">, not with <sdf>",
                      element.name == "robot" ? "URDF is not supported yet" : "");
    return root;
  }
  const std::optional<int> version = readVersion(element, diagnostics);
  Context context{.diagnostics = diagnostics, .version = version.value_or(kNewestVersion), .said = {}};
  checkElements(element, context);

  SiblingNames names("this file");
  for (const Element& child : element.children) {
    if (child.name != "world") continue;
    root.worlds.push_back(readWorld(child, context));
    names.claim(root.worlds.back().name, child.name, child, context);
  }
  if (root.worlds.empty()) {
    const bool hasModel = element.child("model") != nullptr;
    diagnostics.error(
        element.position, "there is no <world> in this file",
        hasModel ? "a model has to stand in a world: <world name=\"...\"><model>...</model></world>" : "");
  }
  return root;
}

/// Adds `found` to `diagnostics` in the order of the file: checks that look at the whole come late.
void addSorted(const Diagnostics& found, Diagnostics& diagnostics) {
  std::vector<Diagnostic> all = found.all();
  std::ranges::stable_sort(all, {}, [](const Diagnostic& diagnostic) {
    return std::tuple(diagnostic.position.line, diagnostic.position.column);
  });
  for (Diagnostic& diagnostic : all) {
    const auto add = diagnostic.severity == Severity::kError ? &Diagnostics::error : &Diagnostics::warning;
    (diagnostics.*add)(std::move(diagnostic.position), std::move(diagnostic.message), std::move(diagnostic.hint));
  }
}

Root load(std::string_view text, const FileName& name, Diagnostics& diagnostics) {
  Diagnostics found;
  Root root;
  if (const std::optional<Element> element = parseDocument(text, name, found)) root = readRoot(*element, found);
  addSorted(found, diagnostics);
  return root;
}

}  // namespace

Root loadFile(const std::filesystem::path& file, Diagnostics& diagnostics) {
  const auto name = std::make_shared<const std::string>(file.string());
  const std::optional<std::string> text = readFileText(file, name, diagnostics);
  return text ? load(*text, name, diagnostics) : Root();
}

Root loadText(std::string_view text, std::string_view name, Diagnostics& diagnostics) {
  return load(text, std::make_shared<const std::string>(name), diagnostics);
}

}  // namespace pongsim::sdf
