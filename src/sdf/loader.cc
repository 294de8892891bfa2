#include "sdf/loader.hh"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "sdf/includes/includes.hh"
#include "sdf/includes/model_document.hh"
#include "sdf/readers/worlds/world_reader.hh"
#include "sdf/schema/element_check.hh"
#include "sdf/text/file_text.hh"
#include "sdf/text/names.hh"
#include "sdf/version.hh"
#include "sdf/xacro/xacro.hh"

namespace pongsim::sdf {

namespace {

using FileName = std::shared_ptr<const std::string>;

/// What was read, with the frames of each world and of everything outside of worlds.
struct Reading {
  Root root;
  std::vector<std::unique_ptr<Scope>> scopes;
};

Reading readRoot(Element& element, const std::shared_ptr<const UrdfSource>& urdf, Includes& includes,
                 const FileName& file, Diagnostics& diagnostics, Diagnostics& unsimulated) {
  Reading reading;
  Root& root = reading.root;
  Context context{.diagnostics = diagnostics,
                  .unsimulated = unsimulated,
                  .includes = includes,
                  .version = readVersion(element, diagnostics),
                  .folder = std::filesystem::path(*file).parent_path(),
                  .urdf = urdf};
  checkElements(element, context);
  includes.modernize(element, context);

  SiblingNames names("this file");
  for (const Element& child : element.children) {
    if (child.name != "world") continue;
    WorldParts parts = readWorld(child, context);
    root.worlds.push_back(std::move(parts.world));
    reading.scopes.push_back(std::move(parts.scope));
    names.claim(root.worlds.back().name, child.name, child, context);
  }
  RootParts parts = readRootParts(element, context);
  root.models = std::move(parts.models);
  root.lights = std::move(parts.lights);
  root.actors = std::move(parts.actors);
  if (!root.models.empty()) reading.scopes.push_back(std::move(parts.scope));
  const bool isEmpty = root.worlds.empty() && root.models.empty() && root.lights.empty() && root.actors.empty();
  if (isEmpty && element.child("include") == nullptr) {
    diagnostics.error(element.position, "there is no <world> and no <model> in this file");
  }
  return reading;
}

/// @return The place in an included file and what is said of it, without the names of models, which depend on who
/// includes the file.
std::string causeOf(const Diagnostic& diagnostic) {
  constexpr std::string_view kModel = "model '";
  Diagnostic cause = diagnostic;
  cause.includedFrom.clear();
  for (std::size_t at = 0; (at = cause.message.find(kModel, at)) != std::string::npos; at += kModel.size()) {
    const std::size_t name = at + kModel.size();
    const std::size_t end = cause.message.find('\'', name);
    if (end != std::string::npos) cause.message.erase(name, end - name);
  }
  return format(cause);
}

/// Adds `found` to `diagnostics`, sorted by position, because some checks run late. A fault of a file that is included
/// several times is reported once.
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
    if (!diagnostic.includedFrom.empty() && !said.insert(causeOf(diagnostic)).second) continue;
    diagnostics.add(std::move(diagnostic));
  }
}

/// Loads one file.
class Load {
 public:
  Load(FileName name, const assets::Finder& finder) : name_(std::move(name)), includes_(finder, found_, unsimulated_) {
    includes_.begin(*name_);
  }

  Reading read(std::string_view text) { return read(text, name_); }

  Reading read(std::string_view text, const FileName& name) {
    std::optional<ModelDocument> document = parseModelDocument(text, name, found_);
    if (!document) return Reading();
    element_ = std::move(document->sdf);
    urdf_ = std::move(document->urdf);
    return readElement();
  }

  Reading read(const Element& sdf) {
    element_ = sdf;
    return readElement();
  }

  Reading readFile(NamedBy by = NamedBy::kUser) {
    const std::optional<ExpandedText> text = readExpandedText(*name_, name_, by, includes_.mayExpand(*name_), found_);
    return text ? read(text->text, text->name) : Reading();
  }

  void prepareToPrint(IncludeUse use) { includes_.prepareToPrint(use == IncludeUse::kReplace); }

  /// @return The file's element with its includes resolved; nothing if there was an error. Call only once.
  std::optional<Element> takeResolved() {
    if (found_.hasErrors()) return std::nullopt;
    includes_.resolve(*element_);
    return std::move(element_);
  }

  bool hasErrors() const { return found_.hasErrors(); }
  void report(Diagnostics& diagnostics) const { addSorted(found_, includes_, diagnostics); }

 private:
  Reading readElement() {
    includes_.bring(*element_);
    Reading reading = readRoot(*element_, urdf_, includes_, name_, found_, unsimulated_);
    addSorted(unsimulated_, includes_, reading.root.unsimulated);
    return reading;
  }

  FileName name_;
  Diagnostics found_;
  Diagnostics unsimulated_;
  Includes includes_;
  std::optional<Element> element_;
  std::shared_ptr<const UrdfSource> urdf_;
};

FileName nameOf(const std::filesystem::path& file) { return std::make_shared<const std::string>(file.string()); }

}  // namespace

Root loadFile(const std::filesystem::path& file, Diagnostics& diagnostics, const assets::Finder& finder, NamedBy by) {
  Load load(nameOf(file), finder);
  Reading reading = load.readFile(by);
  load.report(diagnostics);
  return std::move(reading.root);
}

std::optional<Element> resolveFile(const std::filesystem::path& file, Diagnostics& diagnostics,
                                   const assets::Finder& finder, IncludeUse use) {
  Load load(nameOf(file), finder);
  load.prepareToPrint(use);
  load.readFile();
  load.report(diagnostics);
  return load.takeResolved();
}

std::optional<std::string> frameGraphs(const std::filesystem::path& file, FrameGraphKind kind, Diagnostics& diagnostics,
                                       const assets::Finder& finder) {
  Load load(nameOf(file), finder);
  const Reading reading = load.readFile();
  load.report(diagnostics);
  if (load.hasErrors()) return std::nullopt;
  std::string text;
  for (const std::unique_ptr<Scope>& scope : reading.scopes) text += frameDot(*scope, kind);
  return text;
}

Root loadText(std::string_view text, std::string_view name, Diagnostics& diagnostics, const assets::Finder& finder) {
  Load load(std::make_shared<const std::string>(name), finder);
  Reading reading = load.read(text);
  load.report(diagnostics);
  return std::move(reading.root);
}

Root loadElement(const Element& sdf, Diagnostics& diagnostics, const assets::Finder& finder) {
  const FileName& file = sdf.position.file;
  Load load(file ? file : nameOf({}), finder);
  Reading reading = load.read(sdf);
  load.report(diagnostics);
  return std::move(reading.root);
}

}  // namespace pongsim::sdf
