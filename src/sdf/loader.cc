#include "sdf/loader.hh"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "sdf/element_check.hh"
#include "sdf/file_text.hh"
#include "sdf/includes.hh"
#include "sdf/model_document.hh"
#include "sdf/names.hh"
#include "sdf/version.hh"
#include "sdf/world_reader.hh"

namespace pongsim::sdf {

namespace {

using FileName = std::shared_ptr<const std::string>;

Root readRoot(const Element& element, Includes& includes, const FileName& file, Diagnostics& diagnostics) {
  Root root;
  Context context{.diagnostics = diagnostics,
                  .includes = includes,
                  .version = readVersion(element, diagnostics),
                  .folder = std::filesystem::path(*file).parent_path()};
  checkElements(element, context);

  SiblingNames names("this file");
  for (const Element& child : element.children) {
    if (child.name != "world") continue;
    root.worlds.push_back(readWorld(child, context));
    names.claim(root.worlds.back().name, child.name, child, context);
  }
  RootParts parts = readRootParts(element, context);
  root.models = std::move(parts.models);
  root.lights = std::move(parts.lights);
  if (root.worlds.empty() && root.models.empty() && root.lights.empty() && element.child("actor") == nullptr) {
    diagnostics.error(element.position, "there is no <world> and no <model> in this file");
  }
  return root;
}

/// Adds `found` to `diagnostics` in the order of the file: checks that look at the whole come late. What is wrong with
/// a file that is included several times is told once.
void addSorted(const Diagnostics& found, const Includes& includes, Diagnostics& diagnostics) {
  std::vector<Diagnostic> all = found.all();
  for (Diagnostic& diagnostic : all) diagnostic.includedFrom = includes.chainOf(diagnostic.position);
  std::ranges::stable_sort(all, {}, [](const Diagnostic& diagnostic) {
    const bool isIncluded = !diagnostic.includedFrom.empty();
    const SourcePosition& place = isIncluded ? diagnostic.includedFrom.back() : diagnostic.position;
    const SourcePosition& inner = isIncluded ? diagnostic.position : SourcePosition();
    return std::tuple(place.line, place.column, diagnostic.includedFrom.size(), inner.line, inner.column);
  });
  std::set<std::string> said;
  for (Diagnostic& diagnostic : all) {
    if (!diagnostic.includedFrom.empty()) {
      Diagnostic withoutChain = diagnostic;
      withoutChain.includedFrom.clear();
      if (!said.insert(format(withoutChain)).second) continue;
    }
    diagnostics.add(std::move(diagnostic));
  }
}

Root load(std::string_view text, const FileName& name, const assets::Finder& finder, Diagnostics& diagnostics) {
  Diagnostics found;
  Includes includes(finder, found);
  includes.begin(*name);
  Root root;
  if (const std::optional<Element> element = parseModelDocument(text, name, found)) {
    root = readRoot(*element, includes, name, found);
  }
  addSorted(found, includes, diagnostics);
  return root;
}

}  // namespace

Root loadFile(const std::filesystem::path& file, Diagnostics& diagnostics, const assets::Finder& finder) {
  const auto name = std::make_shared<const std::string>(file.string());
  const std::optional<std::string> text = readFileText(file, name, diagnostics);
  return text ? load(*text, name, finder, diagnostics) : Root();
}

Root loadText(std::string_view text, std::string_view name, Diagnostics& diagnostics, const assets::Finder& finder) {
  return load(text, std::make_shared<const std::string>(name), finder, diagnostics);
}

}  // namespace pongsim::sdf
